"""A headless Chromium, driven by chromedriver's own protocol (W3C WebDriver): nothing but Python's library is needed."""
import base64
import json
import os
import re
import shutil
import subprocess
import tempfile
import time
import urllib.request


def missing():
    """What is not installed, or ""."""
    return " ".join(p for p in ("chromium", "chromedriver") if shutil.which(p) is None)


class Browser:
    def __init__(self, width=1280, height=800):
        self.home = tempfile.mkdtemp()
        self.driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                       text=True)
        port = None
        while port is None:
            line = self.driver.stdout.readline()
            if not line:
                raise RuntimeError("chromedriver does not start")
            found = re.search(r"started successfully on port (\d+)", line)
            port = found and found.group(1)
        self.at = f"http://127.0.0.1:{port}"
        words = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-gl=angle", "--use-angle=swiftshader",
                 "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--force-device-scale-factor=1",
                 f"--window-size={width},{height}", f"--user-data-dir={self.home}"]
        wanted = {"browserName": "chrome", "timeouts": {"script": 170_000, "pageLoad": 170_000}, "goog:chromeOptions": {"args": words, "binary": shutil.which("chromium")},
                  "goog:loggingPrefs": {"browser": "ALL"}}
        self.session = self.ask("POST", "/session", {"capabilities": {"alwaysMatch": wanted}})["sessionId"]

    def ask(self, how, path, body=None, within=180):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.at + path, data=data, method=how,
                                         headers={"Content-Type": "application/json"})
        with urllib.request.urlopen(request, timeout=within) as answer:
            return json.load(answer)["value"]

    def do(self, how, path, body=None):
        return self.ask(how, f"/session/{self.session}{path}", body)

    def open(self, file, patience=120):
        """Seconds until the page says that it is ready, as seen from here."""
        begin = time.monotonic()
        self.do("POST", "/url", {"url": "file://" + os.path.abspath(file)})
        while self.js("return document.documentElement.dataset.ready") != "yes":
            if time.monotonic() - begin > patience:
                raise RuntimeError("the page does not get ready: " + json.dumps(self.log()))
            time.sleep(0.05)
        return time.monotonic() - begin

    def js(self, text, *values):
        return self.do("POST", "/execute/sync", {"script": text, "args": list(values)})

    def key(self, value):
        self.do("POST", "/actions", {"actions": [{"type": "key", "id": "keys", "actions": [
            {"type": "keyDown", "value": value}, {"type": "keyUp", "value": value}]}]})

    def click(self, css):
        self.js("document.querySelector(arguments[0]).click()", css)

    def settle(self):
        """Until what was asked to be drawn is drawn."""
        self.js("Filum.views.forEach(v => v.draw(true))")

    def picture(self, file=None):
        png = base64.b64decode(self.do("GET", "/screenshot"))
        if file:
            with open(file, "wb") as f:
                f.write(png)
        return png

    def log(self):
        return [e["message"] for e in self.do("POST", "/se/log", {"type": "browser"}) if e["level"] == "SEVERE"]

    def close(self):
        try:
            self.do("DELETE", "")
        finally:
            self.driver.terminate()
            self.driver.wait()
            shutil.rmtree(self.home, ignore_errors=True)
