// A shape in 3D. Views share a pose, so that turning one turns all.
import * as three from './three/three.module.js';

const kEye = new three.Vector3(0.45, -0.8, 0.4).normalize();  // where pictures are taken from, too
const kCreases = 40;                                          // degrees; likewise
const kMostEdged = 60000;                                     // triangles: finding creases takes a while
const kRadius = 1.06;                                         // of what is seen; shapes are within 1

/// How all views are turned, and how near they are.
export class Pose {
  turn = new three.Quaternion();
  zoom = 1;
  listeners = [];

  /// About the axes of the screen, in radians.
  rotate(aroundUp, aroundRight) {
    const right = new three.Vector3(0, 0, 1).cross(kEye).normalize();
    const up = kEye.clone().cross(right);
    const step = new three.Quaternion().setFromAxisAngle(up, aroundUp)
        .multiply(new three.Quaternion().setFromAxisAngle(right, aroundRight));
    this.turn.premultiply(step).normalize();
    this.changed();
  }
  magnify(factor) {
    this.zoom = Math.min(20, Math.max(0.5, this.zoom * factor));
    this.changed();
  }
  reset() {
    this.turn.identity();
    this.zoom = 1;
    this.changed();
  }
  changed() {
    for (const listener of this.listeners) listener();
  }
}

/// The mesh in the bytes of the API: see papers/search.md.
function geometryOf(bytes) {
  const head = new Uint32Array(bytes, 0, 4);
  if (head[0] !== 0x48534d52) throw new Error('the server sent no mesh');  // "RMSH"
  const [, vertices, , triangles] = head;
  const geometry = new three.BufferGeometry();
  geometry.setIndex(new three.BufferAttribute(new Uint32Array(bytes, 16, 3 * triangles), 1));
  // As 32-bit numbers: graphics cards dislike points of six bytes.
  const packed = new Int16Array(bytes, 16 + 12 * triangles, 3 * vertices);
  geometry.setAttribute('position', new three.BufferAttribute(Float32Array.from(packed, (x) => x / 32767), 3));
  return geometry;
}

export class View {
  #pose;
  #renderer = new three.WebGLRenderer({antialias: true});
  #scene = new three.Scene();
  #camera = new three.OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
  #shape = new three.Group();  // turned by the pose; what is in it by its own turn first
  #asked = false;

  constructor(box, pose) {
    this.#pose = pose;
    this.#renderer.setClearColor(0xffffff);
    this.#renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.#camera.up.set(0, 0, 1);
    this.#camera.position.copy(kEye).multiplyScalar(4);
    this.#camera.lookAt(0, 0, 0);
    const lamp = new three.DirectionalLight(0xffffff, 2.2);
    lamp.position.set(-0.6, 1.2, 1);
    this.#camera.add(lamp);
    this.#scene.add(this.#camera, this.#shape, new three.HemisphereLight(0xffffff, 0x7d838b, 1.25));
    box.prepend(this.#renderer.domElement);
    pose.listeners.push(() => this.#draw());
    new ResizeObserver(() => this.#draw()).observe(box);
    this.box = box;
  }

  /// `bytes` of a mesh, and the nine numbers by which it is turned before all else.
  show(bytes, rotation = [1, 0, 0, 0, 1, 0, 0, 0, 1]) {
    this.clear();
    const geometry = geometryOf(bytes);
    const surface = new three.MeshLambertMaterial({color: 0xe4e6e9, flatShading: true, side: three.DoubleSide,
                                                   polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1});
    const [a, b, c, d, e, f, g, h, i] = rotation;
    const own = new three.Group();
    own.applyMatrix4(new three.Matrix4(a, b, c, 0, d, e, f, 0, g, h, i, 0, 0, 0, 0, 1));
    own.add(new three.Mesh(geometry, surface));
    if (geometry.index.count / 3 <= kMostEdged)
      own.add(new three.LineSegments(new three.EdgesGeometry(geometry, kCreases),
                                     new three.LineBasicMaterial({color: 0x4a4d52})));
    this.#shape.add(own);
    this.#draw();
  }

  clear() {
    this.#shape.traverse((part) => {
      part.geometry?.dispose();
      part.material?.dispose();
    });
    this.#shape.clear();
    this.#draw();
  }

  /// Once a frame, however often the pose changes.
  #draw() {
    if (this.#asked) return;
    this.#asked = true;
    requestAnimationFrame(() => {
      this.#asked = false;
      const {clientWidth: width, clientHeight: height} = this.box;
      if (!width || !height) return;
      this.#renderer.setSize(width, height, false);
      const unit = kRadius / this.#pose.zoom / Math.min(width, height);
      Object.assign(this.#camera, {left: -width * unit, right: width * unit, top: height * unit, bottom: -height * unit});
      this.#camera.updateProjectionMatrix();
      this.#shape.quaternion.copy(this.#pose.turn);
      this.#renderer.render(this.#scene, this.#camera);
    });
  }
}
