"""The page of `rectilin serve` in a real browser.  Usage: serve_browser.py URL EMPTY_URL FILE BROKEN [PICTURES]

URL serves meshes/ (tori and boxes); FILE is one more torus; BROKEN is no mesh. Screenshots of every page, wide and
narrow, are written to the folder PICTURES, if it is given.
"""
import os
import sys

from browser import Browser

url, empty_url, torus, broken = sys.argv[1:5]
pictures = sys.argv[5] if len(sys.argv) > 5 else None
browser = Browser()


def keep(name):
    if pictures:
        browser.picture(path=os.path.join(pictures, name + ".png"))


def texts(selector):
    return browser.run(f"[...document.querySelectorAll({selector!r})].map(e => e.textContent)")


def loaded():
    """All pictures of the grid have come."""
    browser.until("[...document.images].every(i => i.complete && i.naturalWidth === 280)", "pictures are there")


def browse():
    browser.open(url)
    assert len(texts(".shape")) == 12, texts(".shape")
    loaded()
    keep("browse")
    browser.run("document.querySelector('#words').focus()")
    browser.call("Input.insertText", text="Torus")
    browser.until("document.querySelectorAll('.shape').length === 4", "only tori are shown")
    browser.run("document.querySelector('.shape').focus()")
    browser.key("ArrowRight", 39)
    assert browser.run("document.activeElement.title") == "meshes/torus2.stl"


def search_by_member():
    browser.key("Enter", 13, "\r")
    browser.until("document.querySelector('main.searching') && document.querySelectorAll('.shape').length === 11", "matches are shown")
    assert all("torus" in text for text in texts(".shape")[:3]), texts(".shape")
    distances = [float(text) for text in texts(".shape .value")]
    assert distances == sorted(distances) and distances[0] > 0, distances
    links = browser.run("[...document.querySelectorAll('#query a')].map(a => a.href)")
    assert len(links) == 2
    for link in links:
        assert browser.run(f"fetch({link!r}).then(r => r.text()).then(t => t.includes('torus2'))"), link
    loaded()
    keep("search")


def views():
    return [browser.picture(f".view[data-side={side}]") for side in ("query", "result")]


def settled():
    """Both views as they are once nothing moves any more."""
    before = views()
    for _ in range(20):
        now = views()
        if now == before:
            return now
        before = now
    raise AssertionError("the views never rest")


def turn_models():
    browser.click(".shape")
    browser.until("document.querySelector('#compare').open", "the comparison is open")
    if not viewer:
        print("three.js was not there when rectilin was built: nothing in 3D is tested")
        browser.until("document.querySelectorAll('.view img').length === 2", "pictures take the place of views")
        return browser.key("Escape", 27)
    browser.until("document.querySelector('#compare').dataset.ready", "both meshes are shown")
    first = settled()
    keep("compare")
    browser.run("document.querySelector('.view[data-side=result]').focus()")
    for _ in range(4):
        browser.key("ArrowRight", 39)
    browser.key("ArrowDown", 40)
    turned = settled()
    assert turned[0] != first[0] and turned[1] != first[1], "turning one by keys turns both"
    keep("turned")
    browser.key("Home", 36)
    assert settled() == first, "Home puts them back"
    box = browser.box(".view[data-side=query]")
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    browser.call("Input.dispatchMouseEvent", type="mousePressed", x=x, y=y, button="left", buttons=1, clickCount=1)
    browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=x + 60, y=y + 25, button="left", buttons=1)
    browser.call("Input.dispatchMouseEvent", type="mouseReleased", x=x + 60, y=y + 25, button="left", clickCount=1)
    dragged = settled()
    assert dragged[0] != first[0] and dragged[1] != first[1], "dragging one turns both"
    browser.key("Escape", 27)
    browser.until("!document.querySelector('#compare').open", "Escape closes the comparison")


def drop_files():
    browser.drop(torus)
    browser.until("document.querySelector('#query h2')?.textContent === 'another.ply'", "the dropped file is searched for")
    browser.until("document.querySelectorAll('.shape').length === 12", "matches are shown")
    assert all("torus" in text for text in texts(".shape")[:4]), texts(".shape")
    loaded()
    keep("dropped")
    browser.run("history.back()")
    browser.until("document.querySelector('#query h2')?.textContent === 'torus2.stl'", "Back leads to the search before")
    browser.choose("#file", broken)
    line = browser.until("document.querySelector('#message').textContent", "a broken file is told")
    assert "broken.off" in line and "rectilin-serve" not in line, line
    keep("broken")
    browser.choose("#file", torus)
    browser.until("document.querySelector('#query h2')?.textContent === 'another.ply'", "the file button works")
    assert browser.run("document.querySelector('#message').hidden")


def narrow():
    browser.size(390, 844, mobile=True)
    for name, address in {"browse": url, "search": url + "#like=" + member}.items():
        browser.call("Page.navigate", url="about:blank")  # another # alone would not load the page anew
        browser.open(address)
        browser.until("document.querySelectorAll('.shape').length > 0", "shapes")
        loaded()
        width = browser.run("document.documentElement.scrollWidth")
        assert width <= 390, f"{name} is {width} wide on a phone"
        keep("narrow-" + name)
    browser.click(".shape")
    browser.until("document.querySelector('#compare').open", "the comparison is open")
    if viewer:
        browser.until("document.querySelector('#compare').dataset.ready", "both meshes are shown")
        settled()
    buttons = browser.run("[...document.querySelectorAll('#compare button')].every(b => b.getBoundingClientRect().bottom <= 844)")
    assert buttons, "all buttons of the comparison are on a phone's screen"
    keep("narrow-compare")
    browser.size(1400, 900)


def empty():
    browser.open(empty_url)
    assert "no shapes" in texts("#summary")[0], texts("#summary")
    keep("empty")


try:
    browse()
    viewer = browser.run("fetch('api/collection').then(r => r.json()).then(c => c.viewer)")
    search_by_member()
    member = browser.run("new URLSearchParams(location.hash.slice(1)).get('like')")
    turn_models()
    drop_files()
    narrow()
    empty()
    assert not browser.complaints(), browser.complaints()
    own = (url, empty_url, "about:", "data:", "blob:")
    strange = [a for a in browser.addresses() if not a.startswith(own)]
    assert not strange, f"asked for from elsewhere: {strange}"
finally:
    browser.close()
print("the page: all as expected")
