"""A thousand clients at a time that all send something wrong.  Usage: serve_abuse.py PORT"""
import random
import resource
import selectors
import socket
import sys
import time

port = int(sys.argv[1])
soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
resource.setrlimit(resource.RLIMIT_NOFILE, (min(4096, hard), hard))
random.seed(1)
host = b"Host: 127.0.0.1\r\n"
noise = bytes(random.randrange(256) for _ in range(4000))
kinds = [
    b"",                                                                  # hangs up
    noise,
    b"GET",                                                               # half a line
    b"GET / HTTP/1.1\r\n" + host,                                         # no end of headers
    b"GET / HTTP/1.1\r\n\r\n",                                            # no host
    b"GET / HTTP/9.9\r\n" + host + b"\r\n",
    b"\0\0\0\0\r\n\r\n",
    b"GET /" + b"a" * 100_000 + b" HTTP/1.1\r\n" + host + b"\r\n",
    b"A" * 200_000,                                                       # no line ends
    b"GET / HTTP/1.1\r\n" + b"X: y\r\n" * 20_000 + b"\r\n",               # too many headers
    b"GET / HTTP/1.1\r\nX: " + b"y" * 100_000 + b"\r\n\r\n",
    b"POST /api/search?file=a.off HTTP/1.1\r\n" + host + b"Content-Length: 99999999999999999999\r\n\r\n",
    b"POST /api/search?file=a.off HTTP/1.1\r\n" + host + b"Content-Length: -1\r\n\r\n",
    b"POST /api/search?file=a.off HTTP/1.1\r\n" + host + b"Content-Length: 12\r\nContent-Length: 5\r\n\r\nOFF",
    b"POST /api/search?file=a.off HTTP/1.1\r\n" + host + b"Content-Length: 1000000\r\n\r\nOFF",   # the rest never comes
    b"POST /api/search?file=a.off HTTP/1.1\r\n" + host + b"Transfer-Encoding: chunked\r\n\r\nFFFFFFFFFFFFFFFF\r\n",
    b"POST /api/search HTTP/1.1\r\n" + host + b"Content-Length: 3\r\n\r\nOFF",                    # no name
    b"GET /api/mesh?id=%00%ff%zz HTTP/1.1\r\n" + host + b"\r\n",
    b"GET /api/search?id=1&count=-5 HTTP/1.1\r\n" + host + b"\r\n",
    b"GET /%2e%2e/%2e%2e/etc/passwd HTTP/1.1\r\n" + host + b"\r\n",
    b"GET / HTTP/1.1\r\n" + host + b"Range: bytes=" + b",".join(b"0-" for _ in range(2000)) + b"\r\n\r\n",
    b"TRACE / HTTP/1.1\r\n" + host + b"\r\n",
    b"CONNECT x:1 HTTP/1.1\r\n" + host + b"\r\n",
]
selector = selectors.DefaultSelector()
clients = 0
for i in range(1000):
    s = socket.socket()
    s.setblocking(False)
    s.connect_ex(("127.0.0.1", port))
    selector.register(s, selectors.EVENT_READ | selectors.EVENT_WRITE, kinds[i % len(kinds)])
    clients += 1
answers = {}
end = time.monotonic() + 8
while selector.get_map() and time.monotonic() < end:
    for key, events in selector.select(0.5):
        s, left = key.fileobj, key.data
        try:
            if events & selectors.EVENT_READ:
                got = s.recv(65536)
                if got.startswith(b"HTTP/1.1 "):
                    answers[got[9:12]] = answers.get(got[9:12], 0) + 1
                if not got or got.startswith(b"HTTP/1.1 "):
                    raise ConnectionError
            if events & selectors.EVENT_WRITE:
                if left:
                    left = left[s.send(left[:65536]):]
                selector.modify(s, selectors.EVENT_READ | (selectors.EVENT_WRITE if left else 0), left)
        except OSError:
            selector.unregister(s)
            s.close()
for key in list(selector.get_map().values()):
    key.fileobj.close()
print(clients, "clients;", ", ".join(f"{n} times {code.decode()}" for code, n in sorted(answers.items())))
assert not any(code.startswith(b"5") and code not in (b"503", b"505", b"501") for code in answers), answers
assert b"200" not in answers or answers[b"200"] < 60, answers
