// A page in a headless Chromium, driven through a pipe by the DevTools protocol.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

export class Browser {
  // `window` is "1280,900"; `more` are further options.
  static async open(window, more = []) {
    const browser = new Browser();
    browser.profile = mkdtempSync(join(tmpdir(), "browser-"));
    // Browsers refuse to run as root, as containers do, with their sandbox on.
    browser.process = spawn("chromium", ["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
      "--hide-scrollbars", `--user-data-dir=${browser.profile}`, `--window-size=${window}`, "--remote-debugging-pipe",
      ...more, "about:blank"], { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    browser.calls = new Map();
    browser.errors = [];
    browser.number = 0;
    browser.rest = "";
    browser.process.stdio[4].on("data", (data) => browser.hear(String(data)));
    browser.process.on("exit", () => {
      for (const { fail } of browser.calls.values()) fail(new Error("the browser has ended"));
    });
    const { targetInfos } = await browser.call("Target.getTargets");
    const { targetId } = targetInfos.find(({ type }) => type === "page");
    ({ sessionId: browser.session } = await browser.call("Target.attachToTarget", { targetId, flatten: true }));
    for (const domain of ["Page", "Runtime", "DOM"]) await browser.call(`${domain}.enable`);
    return browser;
  }

  hear(data) {
    const messages = (this.rest + data).split("\0");
    this.rest = messages.pop();
    for (const text of messages) {
      const { id, method, params, result, error } = JSON.parse(text);
      if (method === "Runtime.exceptionThrown") {
        this.errors.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
      }
      if (method === "Page.loadEventFired") this.loaded?.();
      const call = this.calls.get(id);
      this.calls.delete(id);
      if (error) call?.fail(new Error(error.message));
      else call?.done(result);
    }
  }

  call(method, params = {}) {
    const id = ++this.number, session = this.session ? { sessionId: this.session } : {};
    this.process.stdio[3].write(`${JSON.stringify({ id, method, params, ...session })}\0`);
    return new Promise((done, fail) => this.calls.set(id, { done, fail }));
  }

  // The file, with or without a place (#...), loaded anew.
  async visit(file) {
    // From the same page a place alone would load nothing.
    for (const url of ["about:blank", `file://${file}`]) {
      const loaded = new Promise((done) => { this.loaded = done; });
      await this.call("Page.navigate", { url });
      await loaded;
    }
  }

  // The value of an expression in the page; of a promise, when it is kept.
  async evaluate(expression) {
    const { result, exceptionDetails } = await this.call("Runtime.evaluate",
      { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  // The files become those of the input.
  async choose(selector, files) {
    const { root } = await this.call("DOM.getDocument");
    const { nodeId } = await this.call("DOM.querySelector", { nodeId: root.nodeId, selector });
    await this.call("DOM.setFileInputFiles", { nodeId, files });
  }

  async resize(width, height) {
    await this.call("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: false });
  }

  // Media features such as { "prefers-color-scheme": "dark" }.
  async prefer(features) {
    await this.call("Emulation.setEmulatedMedia",
      { features: Object.entries(features).map(([name, value]) => ({ name, value })) });
  }

  async screenshot(whole = false) {
    const { data } = await this.call("Page.captureScreenshot", { captureBeyondViewport: whole });
    return Buffer.from(data, "base64");
  }

  async close() {
    const ended = new Promise((done) => this.process.on("exit", done));
    this.session = undefined;
    this.call("Browser.close").catch(() => {});
    await ended;
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}
