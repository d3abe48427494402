"""Opens every page of the built site in Chromium, wide and narrow: pictures that do not load, links that lead to nothing, text
that runs out of the screen, code and small tables that a wide screen clips, errors of scripts, buttons and marks that do nothing. Fails with the
list; keeps screenshots.

    look.py SITE SCREENSHOTS
"""

from __future__ import annotations

import functools
import html
import http.server
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import threading
import urllib.parse

WIDTHS = (1280, 390)
SHOTS = ["docs/index.html", "docs/tutorial.html", "docs/first_path.html", "docs/cookbook.html", "docs/import.html", "docs/theory.html", "docs/coupling.html", "docs/options.html", "docs/paraview.html",
         "docs/reference/stepping.html", "docs/python_reference.html", "examples/centre_crack/README.html", "README.html"]

# Runs in every page before its own scripts. Frames of pictures do not come reliably with virtual time, so they come by the clock.
RECORDER = """<script>
window.faults = [];
addEventListener('error', e => faults.push(e.message || `${e.target.tagName} ${e.target.src || e.target.href} does not load`), true);
addEventListener('unhandledrejection', e => faults.push(`a promise fails: ${e.reason}`));
console.error = (...words) => faults.push(words.join(' '));
requestAnimationFrame = run => setTimeout(run, 16);
cancelAnimationFrame = clearTimeout;
</script>"""

# Runs in the browser: each page in a frame of each width.
SCRIPT = """
const pages = PAGES, widths = WIDTHS, found = [], seen = new Map();
const exists = url => { if (!seen.has(url)) seen.set(url, fetch(url, {method: 'HEAD'}).then(r => r.ok, () => false)); return seen.get(url); };
const load = (page, width) => new Promise(done => {
  const frame = document.createElement('iframe');
  frame.style.cssText = `width:${width}px;height:900px;border:0`;
  const scroll = () => {
    frame.contentWindow.scrollTo({top: 1e6, behavior: 'instant'});
    frame.contentWindow.dispatchEvent(new Event('scroll'));
    setTimeout(() => done(frame), 200);
  };
  frame.onload = () => setTimeout(scroll, 400);
  frame.src = page; document.body.appendChild(frame);
});
(async () => {
  for (const page of pages) for (const width of widths) {
    const frame = await load(page, width), doc = frame.contentDocument;
    const over = doc.documentElement.scrollWidth - doc.documentElement.clientWidth;
    if (over > 1) {
      const wide = [...doc.querySelectorAll('article *')].filter(e => e.getBoundingClientRect().right > width + 1 && !e.closest('table, pre, .MathJax_CHTML'));
      found.push(`${page}: ${over} pixels too wide at ${width}: ${wide.slice(0, 2).map(e => e.tagName + ' ' + e.textContent.trim().slice(0, 60)).join(' | ')}`);
    }
    for (const fault of new Set(frame.contentWindow.faults)) found.push(`${page}: ${fault}`);
    if (width === widths[0]) {
      const before = doc.body.dataset.theme, button = [...doc.querySelectorAll('.theme-toggle')].pop();
      if (button) button.click();
      if (button && doc.body.dataset.theme === before) found.push(`${page}: the theme button does nothing`);
      localStorage.removeItem('theme');
      if (doc.querySelector('.toc-tree li li') && !doc.querySelector('.toc-tree .scroll-current')) found.push(`${page}: the contents mark no place`);
      for (const code of doc.querySelectorAll('article pre')) if (code.scrollWidth > code.clientWidth + 1)
        found.push(`${page}: code is clipped: ${code.textContent.split('\\n').sort((a, b) => b.length - a.length)[0].trim().slice(0, 60)}`);
      for (const table of doc.querySelectorAll('article table')) if (table.rows[0].cells.length <= 6 && table.scrollWidth > table.clientWidth + 1)
        found.push(`${page}: a table is clipped: ${table.textContent.trim().slice(0, 60)}`);
      for (const image of doc.images) if (image.loading !== 'lazy' && image.naturalWidth === 0) found.push(`${page}: picture ${image.getAttribute('src')} does not load`);
      for (const link of doc.querySelectorAll('article a[href]')) {
        const url = new URL(link.href);
        if (url.origin !== location.origin) continue;
        if (!await exists(url.pathname)) found.push(`${page}: link ${link.getAttribute('href')} leads to nothing`);
        else if (url.hash && url.pathname === new URL(page, location).pathname && !doc.getElementById(decodeURIComponent(url.hash.slice(1))))
          found.push(`${page}: there is no ${url.hash}`);
      }
      const prose = doc.querySelector('article') ? doc.querySelector('article').cloneNode(true) : doc.createElement('p');
      for (const code of prose.querySelectorAll('pre, code, script')) code.remove();
      if (/\\$\\$|\\\\frac|\\\\sqrt/.test(prose.textContent)) found.push(`${page}: a formula is not drawn`);
    }
    frame.remove();
  }
  document.body.innerHTML = '<pre id="found"></pre>';
  document.getElementById('found').textContent = JSON.stringify({found, pages: pages.length});
  document.title = 'done';
})();
"""


class Quiet(http.server.SimpleHTTPRequestHandler):
    missing: set[str] = set()

    def log_message(self, *_: object) -> None:
        pass

    def send_error(self, code: int, *arguments: object) -> None:
        if self.command == "GET" and self.path != "/favicon.ico":  # the other calls ask where links lead
            self.missing.add(f"{self.headers.get('Referer', 'a page')}: {self.path} is not there")
        super().send_error(code, *arguments)

    def do_GET(self) -> None:
        page = pathlib.Path(self.translate_path(self.path))
        if page.suffix != ".html" or not page.is_file():
            return super().do_GET()
        text = page.read_bytes().replace(b"<head>", b"<head>" + RECORDER.encode(), 1)
        self.send_response(200)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.send_header("Content-Length", str(len(text)))
        self.end_headers()
        self.wfile.write(text)


def chromium(*arguments: str) -> str:
    with tempfile.TemporaryDirectory() as profile:
        run = subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", f"--user-data-dir={profile}",
                              *arguments], capture_output=True, text=True, timeout=900, check=True)
    return run.stdout


def main() -> int:
    site, shots = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    shots.mkdir(parents=True, exist_ok=True)
    pages = sorted("/" + urllib.parse.quote(str(page.relative_to(site))) for page in site.rglob("*.html")
                   if page.relative_to(site).parts[0] not in ("rust", "_static", "_modules"))
    harness = site / "_look.html"
    script = SCRIPT.replace("PAGES", json.dumps(pages)).replace("WIDTHS", json.dumps(WIDTHS), 1)
    harness.write_text(f"<!doctype html><meta charset='utf-8'><title>looking</title><body><script>{script}</script>", encoding="utf-8")
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=str(site)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_port}"
    try:
        text = chromium(f"--virtual-time-budget={2000 * len(pages) * len(WIDTHS)}", "--dump-dom", f"{address}/_look.html")
        for page in SHOTS:
            for width in WIDTHS:
                target = shots / f"{page.removesuffix('.html').replace('/', '_')}_{width}.png"
                chromium(f"--window-size={width},{1400}", "--virtual-time-budget=6000", f"--screenshot={target}", f"{address}/{page}")
    finally:
        server.shutdown()
        harness.unlink()
    answer = re.search(r'<pre id="found">(.*?)</pre>', text, re.DOTALL)
    if not answer:
        print("the browser did not come to an end")
        return 1
    result = json.loads(html.unescape(answer[1]))
    result["found"] += sorted(Quiet.missing)
    print("\n".join(result["found"]) or f"{result['pages']} pages at {' and '.join(map(str, WIDTHS))} pixels: nothing broken, nothing too wide, no error of a script")
    print(f"screenshots: {shots}")
    return int(bool(result["found"]))


if __name__ == "__main__":
    sys.exit(main())
