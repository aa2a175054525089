// The pages' promises to all who use them (WCAG 2.1, level AA), asked of a page as it is shown: names and roles,
// contrast of texts, sizes of targets, no scrolling to the side.

// Runs in the page; returns what is wrong.
function faults() {
  const found = [];
  const isSeen = (node) => node.checkVisibility({ visibilityProperty: true }) && node.getClientRects().length > 0;
  const colourOf = (text) => {
    const paint = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
    paint.fillStyle = text;
    paint.fillRect(0, 0, 1, 1);
    const [r, g, b, a] = paint.getImageData(0, 0, 1, 1).data;
    return [r, g, b, a / 255];
  };
  const over = (top, below) => top.slice(0, 3).map((c, k) => c * top[3] + below[k] * (1 - top[3]));
  const luminance = (rgb) => {
    const [r, g, b] = rgb.map((c) => (c <= 10.314 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const ground = (node) => {
    const layers = [];
    for (let at = node; at; at = at.parentElement) layers.push(colourOf(getComputedStyle(at).backgroundColor));
    const base = matchMedia("(prefers-color-scheme: dark)").matches ? [18, 18, 18] : [255, 255, 255];
    return layers.reduceRight((below, layer) => over(layer, below), base);
  };
  const say = (node, words) => found.push(`${node.tagName.toLowerCase()}${node.id ? `#${node.id}` : ""}`
    + `${node.className && typeof node.className === "string" ? `.${node.className}` : ""}: ${words}`);
  // Contrast of texts.
  for (const node of document.querySelectorAll("body *")) {
    const own = [...node.childNodes].some((child) => child.nodeType === Node.TEXT_NODE && child.textContent.trim() !== "");
    if (!own || !isSeen(node) || node.closest("svg, script, template, noscript") || node.matches(":disabled")) continue;
    const style = getComputedStyle(node), below = ground(node);
    let opacity = 1;
    for (let at = node; at; at = at.parentElement) opacity *= Number(getComputedStyle(at).opacity);
    const ink = colourOf(style.color), pair = [luminance(over([...ink.slice(0, 3), ink[3] * opacity], below)), luminance(below)];
    const contrast = (Math.max(...pair) + 0.05) / (Math.min(...pair) + 0.05), size = parseFloat(style.fontSize);
    const isLarge = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    if (contrast < (isLarge ? 3 : 4.5)) say(node, `contrast ${contrast.toFixed(2)} of "${node.textContent.trim().slice(0, 30)}"`);
  }
  // Names and targets.
  const nameOf = (node) => {
    const by = node.getAttribute("aria-labelledby");
    const labels = node.labels ? [...node.labels].map((label) => label.textContent) : [];
    const inside = /^(BUTTON|A|SUMMARY)$/.test(node.tagName) || node.getAttribute("role") === "option" ? node.textContent : "";
    return [node.getAttribute("aria-label"), by && by.split(" ").map((id) => document.getElementById(id)?.textContent).join(" "),
      ...labels, inside, node.title].find((words) => words && words.trim() !== "");
  };
  const controls = "button, input, select, summary, a[href], [role=slider], [role=option], [tabindex='0'], canvas, svg[role], progress";
  for (const node of document.querySelectorAll(controls)) {
    if (!isSeen(node) || node.getAttribute("aria-hidden") === "true" || node.closest("[aria-hidden=true]")) continue;
    if (!nameOf(node)) say(node, "no name");
    if (node.tagName === "CANVAS" && !node.getAttribute("role")) say(node, "no role");
    if (!node.matches("button, input, select, summary, a[href], [role=slider], [role=option]") || node.disabled) continue;
    // The target of a box is its label, too.
    const boxes = [node, ...(node.matches("[type=checkbox], [type=radio]") ? node.labels : [])].map((one) => one.getBoundingClientRect());
    const width = Math.max(...boxes.map((box) => box.width)), height = Math.max(...boxes.map((box) => box.height));
    if (width < 24 || height < 24) say(node, `a target of ${width.toFixed(0)} by ${height.toFixed(0)} pixels`);
  }
  const ids = [...document.querySelectorAll("[id]")].map((node) => node.id);
  ids.filter((id, k) => ids.indexOf(id) !== k).forEach((id) => found.push(`the id ${id} is there twice`));
  if (!document.documentElement.lang) found.push("the page has no language");
  if (document.querySelectorAll("h1").length !== 1) found.push("not one main heading");
  if (!document.querySelector("main")) found.push("no main part");
  if (document.documentElement.scrollWidth > innerWidth) found.push(`${document.documentElement.scrollWidth} pixels wide`);
  return found;
}

// Faults of the page that the browser shows, in light and dark, wide and narrow; `prepare` is called for each after
// loading.
export async function accessibilityFaults(browser, page, prepare = async () => {}) {
  const all = [];
  for (const scheme of ["light", "dark"]) {
    for (const [width, height] of [[1280, 900], [390, 844]]) {
      await browser.prefer({ "prefers-color-scheme": scheme });
      await browser.resize(width, height);
      await browser.visit(page);
      await prepare();
      for (const fault of await browser.evaluate(`(${faults})()`)) all.push(`${scheme}, ${width}: ${fault}`);
    }
  }
  return all;
}
