#!/usr/bin/env bash
# The page of rectilin serve in a real browser. Screenshots go to the folder RECTILIN_PICTURES, if that is set.
# Usage: serve_page.sh RECTILIN
here=$(cd "$(dirname "$0")" && pwd)
python3 -B -c "import sys; sys.path.insert(0, '$here'); import browser; sys.exit(browser.chromium() is None)" ||
  { echo "skipped: there is no Chromium"; exit 77; }
. "$here/expect.sh"
. "$here/serving.sh"

"$rectilin" index none -o empty.db -d r >/dev/null 2>&1
start empty empty.db; empty_url=$url
start shapes shapes.db
timeout 600 python3 -B "$here/serve_browser.py" "$url" "$empty_url" another.ply broken.off \
  ${RECTILIN_PICTURES:+"$RECTILIN_PICTURES"} || fail "the page in a browser"
finish serve_page
