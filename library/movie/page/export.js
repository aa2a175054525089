"use strict";
// Saves from the page: the picture as PNG, and a film of the next seconds as WebM, as browsers record a canvas.

const FILM_SECONDS = 10;
const FILM_RATE = 30;  // pictures a second
const FILM_TYPES = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"];

class Exporter {
  // `caption` gives the words that stand in the picture.
  constructor(canvas, caption) {
    this.source = canvas;
    this.caption = caption;
    this.recorder = null;
    this.frame = document.createElement("canvas");
  }

  get isRecording() {
    return this.recorder !== null;
  }

  // The canvas on its ground, with the caption.
  compose() {
    const { frame, source } = this, context = frame.getContext("2d");
    // Encoders want even numbers.
    const width = source.width & ~1, height = source.height & ~1;
    if (frame.width !== width || frame.height !== height) Object.assign(frame, { width, height });
    const style = getComputedStyle(document.body), pixels = source.width / Math.max(1, source.clientWidth);
    context.fillStyle = style.backgroundColor;
    context.fillRect(0, 0, width, height);
    context.drawImage(source, 0, 0);
    context.fillStyle = style.color;
    context.font = `600 ${18 * pixels}px system-ui, "DejaVu Sans", sans-serif`;
    context.textBaseline = "top";
    context.fillText(this.caption(), 16 * pixels, 14 * pixels);
    return frame;
  }

  static save(blob, name) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }

  picture() {
    return new Promise((done) => this.compose().toBlob(done, "image/png"));
  }

  // The film, when it is over. Throws where the browser cannot record.
  film() {
    const type = typeof MediaRecorder === "undefined" ? undefined : FILM_TYPES.find((one) => MediaRecorder.isTypeSupported(one));
    if (type === undefined) throw new Error("this browser does not record WebM");
    const pieces = [];
    this.recorder = new MediaRecorder(this.compose().captureStream(FILM_RATE), { mimeType: type, videoBitsPerSecond: 6e6 });
    const timer = setTimeout(() => this.stop(), 1000 * FILM_SECONDS);
    return new Promise((done, fail) => {
      this.recorder.ondataavailable = ({ data }) => pieces.push(data);
      this.recorder.onerror = ({ error }) => fail(error);
      this.recorder.onstop = () => {
        clearTimeout(timer);
        this.recorder = null;
        done(new Blob(pieces, { type: "video/webm" }));
      };
      this.recorder.start();
    });
  }

  stop() {
    if (this.recorder?.state === "recording") this.recorder.stop();
  }
}
