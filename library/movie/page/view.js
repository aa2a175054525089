"use strict";
// From the plane to the canvas: the part of the plane that is seen, moved by pointer and wheel.

class View {
  constructor(canvas) {
    this.canvas = canvas;
    this.width = this.height = 1;  // size of the canvas, in CSS pixels
    this.pixels = 1;               // device pixels in one
    this.reset();
  }

  reset() {
    this.x = this.y = 0;  // the middle of what is seen
    this.zoom = 1;  // 1: the container fills the canvas
  }

  // Follows the size of the element.
  fit() {
    const { clientWidth, clientHeight } = this.canvas;
    const pixels = window.devicePixelRatio || 1;
    const width = Math.max(1, Math.round(clientWidth * pixels));
    const height = Math.max(1, Math.round(clientHeight * pixels));
    this.width = Math.max(1, clientWidth);
    this.height = Math.max(1, clientHeight);
    this.pixels = pixels;
    if (this.canvas.width === width && this.canvas.height === height) return;
    this.canvas.width = width;
    this.canvas.height = height;
  }

  // CSS pixels in a unit of length, the container's radius.
  get scale() {
    const room = Math.max(1, Math.min(this.width, this.height) - 28);
    return this.zoom * room / 2;
  }

  // Lets the drawing context take coordinates of the plane, y upwards.
  apply(context) {
    const k = this.scale * this.pixels;
    context.setTransform(k, 0, 0, -k, this.width * this.pixels / 2 - k * this.x,
      this.height * this.pixels / 2 + k * this.y);
  }

  // The point of the plane at a point of the canvas, in CSS pixels.
  plane(px, py) {
    return [this.x + (px - this.width / 2) / this.scale,
      this.y - (py - this.height / 2) / this.scale];
  }

  // And the other way.
  canvasPoint(x, y) {
    return [this.width / 2 + this.scale * (x - this.x),
      this.height / 2 - this.scale * (y - this.y)];
  }

  zoomAt(px, py, factor) {
    const [x, y] = this.plane(px, py);
    const zoom = Math.min(2000, Math.max(0.5, this.zoom * factor));
    const share = this.zoom / zoom;
    this.x = x + (this.x - x) * share;
    this.y = y + (this.y - y) * share;
    this.zoom = zoom;
  }

  // Calls `changed` after each movement, `clicked` with the point where a click was none.
  listen(changed, clicked) {
    const canvas = this.canvas;
    let down = null;
    canvas.addEventListener("pointerdown", (event) => {
      down = { x: event.offsetX, y: event.offsetY, moved: false };
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!down || event.buttons === 0) return;
      const dx = event.offsetX - down.x, dy = event.offsetY - down.y;
      if (!down.moved && Math.hypot(dx, dy) < 4) return;
      down = { x: event.offsetX, y: event.offsetY, moved: true };
      this.x -= dx / this.scale;
      this.y += dy / this.scale;
      changed();
    });
    canvas.addEventListener("pointerup", (event) => {
      if (down && !down.moved) clicked(...this.plane(event.offsetX, event.offsetY));
      down = null;
    });
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoomAt(event.offsetX, event.offsetY, Math.exp(-event.deltaY / 400));
      changed();
    }, { passive: false });
    canvas.addEventListener("dblclick", () => {
      this.reset();
      changed();
    });
  }
}
