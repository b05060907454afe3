"""Drives Chromium over a pipe (the DevTools protocol), with nothing but Python's own library."""
import fcntl
import json
import os
import re
import select
import shutil
import subprocess
import tempfile
import time


def chromium():
    """The program, or None."""
    return shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


class Browser:
    """One page. Everything waits: for answers, and by `until` for what the page does."""

    def __init__(self, width=1400, height=900, mobile=False):
        self.profile = tempfile.mkdtemp(prefix="rectilin-browser-")
        # The browser reads commands from descriptor 3 and writes answers to 4. Ours are above, so that none is in the way.
        ends = os.pipe() + os.pipe()
        to_read, self.out, self.into, to_write = (fcntl.fcntl(end, fcntl.F_DUPFD_CLOEXEC, 10) for end in ends)
        for end in ends:
            os.close(end)
        command = [chromium(), "--headless=new", "--remote-debugging-pipe", f"--user-data-dir={self.profile}",
                   "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-first-run", "--disable-extensions",
                   "--disable-dev-shm-usage", "--disable-background-networking", f"--window-size={width},{height}",
                   "--hide-scrollbars"] + (["--no-sandbox"] if os.geteuid() == 0 else []) + ["about:blank"]
        self.process = subprocess.Popen(command, pass_fds=(3, 4), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                        preexec_fn=lambda: (os.dup2(to_read, 3), os.dup2(to_write, 4)))
        os.close(to_read)
        os.close(to_write)
        self.buffer, self.number, self.events, self.session = b"", 0, [], None
        target = next(t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network", "DOM"):
            self.call(domain + ".enable")
        self.size(width, height, mobile)

    def size(self, width, height, mobile=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, mobile=mobile,
                  deviceScaleFactor=2 if mobile else 1)
        self.call("Emulation.setTouchEmulationEnabled", enabled=mobile)

    def receive(self, patience):
        while b"\0" not in self.buffer:
            if not select.select([self.into], [], [], patience)[0]:
                raise TimeoutError("the browser says nothing")
            got = os.read(self.into, 1 << 20)
            if not got:
                raise RuntimeError("the browser ended")
            self.buffer += got
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.out, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive(60)
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self.events.append(answer)

    def run(self, script):
        """The value of a JavaScript expression, awaited."""
        answer = self.call("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"].get("exception", {}).get("description", "exception") + "\n" + script)
        return answer["result"].get("value")

    def until(self, script, what, patience=60):
        end = time.monotonic() + patience
        while time.monotonic() < end:
            try:
                value = self.run(script)
                if value:
                    return value
            except RuntimeError as error:
                if "context" not in str(error):  # the page is being replaced by the next
                    raise
            time.sleep(0.05)
        raise AssertionError(f"never happened: {what}\n{self.run('document.body.innerText')}")

    def open(self, url):
        self.call("Page.navigate", url=url)
        self.until(f"location.href.startsWith({json.dumps(url)}) && document.documentElement?.dataset.ready", "the page is ready")

    def click(self, selector):
        self.run(f"document.querySelector({json.dumps(selector)}).click()")

    def key(self, name, code=0, text=None):
        down = {"type": "keyDown", "key": name, "code": name, "windowsVirtualKeyCode": code}
        if text:
            down["text"] = text
        self.call("Input.dispatchKeyEvent", **down)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=name, code=name, windowsVirtualKeyCode=code)

    def box(self, selector):
        return self.run(f"(({{x, y, width, height}}) => ({{x, y, width, height}}))"
                        f"(document.querySelector({json.dumps(selector)}).getBoundingClientRect())")

    def drop(self, path, x=300, y=300):
        """Drops a file on the page, as a file manager would."""
        data = {"items": [], "files": [os.path.abspath(path)], "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "dragOver", "drop"):
            self.call("Input.dispatchDragEvent", type=kind, x=x, y=y, data=data)
            self.run("new Promise(then => requestAnimationFrame(() => requestAnimationFrame(then)))")

    def choose(self, selector, path):
        """Chooses a file with a file input."""
        root = self.call("DOM.getDocument")["root"]["nodeId"]
        node = self.call("DOM.querySelector", nodeId=root, selector=selector)["nodeId"]
        self.call("DOM.setFileInputFiles", nodeId=node, files=[os.path.abspath(path)])

    def picture(self, selector=None, path=None):
        """A screenshot of the page or of a part, as base64; also written to a file, if one is named."""
        clip = {"clip": {**self.box(selector), "scale": 1}} if selector else {}
        data = self.call("Page.captureScreenshot", format="png", **clip)["data"]
        if path:
            import base64
            with open(path, "wb") as file:
                file.write(base64.b64decode(data))
        return data

    def complaints(self):
        """What the page complained of: exceptions, errors on the console, policies broken; not answers of 4xx."""
        texts = []
        for event in self.events:
            p = event.get("params", {})
            if event.get("method") == "Runtime.exceptionThrown":
                texts.append(p["exceptionDetails"].get("exception", {}).get("description", "exception"))
            if event.get("method") == "Log.entryAdded" and p["entry"]["level"] == "error":
                if not re.search(r"status of 4\d\d", p["entry"]["text"]):
                    texts.append(p["entry"]["text"])
        return texts

    def addresses(self):
        """Every address that was asked for."""
        return [e["params"]["request"]["url"] for e in self.events if e.get("method") == "Network.requestWillBeSent"]

    def close(self):
        try:
            self.call("Browser.close")
            self.process.wait(10)
        except (RuntimeError, OSError, TimeoutError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
        os.close(self.out)
        os.close(self.into)
        shutil.rmtree(self.profile, ignore_errors=True)
