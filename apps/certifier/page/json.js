"use strict";
// JSON (RFC 8259) read strictly: no field twice, 16 levels, no number that a binary64 cannot come near.
// Numbers keep their text; every value knows its place for messages.

// `kind` is "object" (value: a Map), "list", "string", "number" (value: the text), "null" or "boolean".
class JsonValue {
  constructor(kind, at, parent, key) {
    this.kind = kind;
    this.at = at;
    this.parent = parent;
    this.key = key;
    this.value = null;
  }

  // The name of the field, as disks[1].velocity[0]; "" for the whole text.
  get path() {
    if (this.parent === null) return "";
    if (this.parent.kind === "list") return `${this.parent.path}[${this.key}]`;
    return this.parent.parent === null ? this.key : `${this.parent.path}.${this.key}`;
  }

  has(name) {
    return this.value.has(name);
  }

  get(name) {
    return this.value.get(name);
  }
}

const JSON_NUMBER = /-?(?:0|[1-9][0-9]*)(\.[0-9]+)?([eE][-+]?[0-9]+)?/y;
const JSON_WORD = /true|false|null/y;
const JSON_SPACE = /[ \t\n\r]*/y;
const JSON_PLAIN = /[^"\\\u0000-\u001f]*/y;
const JSON_ESCAPES = { '"': '"', "\\": "\\", "/": "/", b: "\b", f: "\f", n: "\n", r: "\r", t: "\t" };
const MOST_CHARACTERS = 4096;
const MOST_LEVELS = 16;
const MOST_TEXT = 1 << 20;

class JsonReader {
  constructor(text) {
    this.text = text;
    this.at = 0;
    this.levels = 0;
  }

  read() {
    const value = this.readValue(null, "");
    if (this.at < this.text.length) this.fail("not JSON", value);
    return value;
  }

  fail(reason, value) {
    invalid(reason, { at: this.at, field: value ? value.path : "" });
  }

  match(expression) {
    expression.lastIndex = this.at;
    const found = expression.exec(this.text);
    if (found) this.at = expression.lastIndex;
    return found;
  }

  // Passes the character, if it is there, and the blanks after it.
  take(character) {
    if (this.text[this.at] !== character) return false;
    ++this.at;
    this.match(JSON_SPACE);
    return true;
  }

  readValue(parent, key) {
    this.match(JSON_SPACE);
    const value = new JsonValue("null", this.at, parent, key), first = this.text[this.at];
    if (first === "{") this.readObject(value);
    else if (first === "[") this.readList(value);
    else if (first === '"') this.readString(value);
    else if (first === "-" || (first >= "0" && first <= "9")) this.readNumber(value);
    else this.readWord(value);
    this.match(JSON_SPACE);
    return value;
  }

  enter(value) {
    if (++this.levels > MOST_LEVELS) this.fail("nested too deeply", value);
    ++this.at;
    this.match(JSON_SPACE);
  }

  readObject(value) {
    value.kind = "object";
    value.value = new Map();
    this.enter(value);
    if (!this.take("}")) {
      do {
        if (this.text[this.at] !== '"') this.fail("not JSON", value);
        const place = this.at, name = this.readText(value);
        if (value.value.has(name)) {
          this.at = place;
          this.fail(`the field '${name}' occurs twice`, value);
        }
        this.match(JSON_SPACE);
        if (!this.take(":")) this.fail("not JSON", value);
        value.value.set(name, this.readValue(value, name));
      } while (this.take(","));
      if (!this.take("}")) this.fail("not JSON", value);
    }
    --this.levels;
  }

  readList(value) {
    value.kind = "list";
    value.value = [];
    this.enter(value);
    if (!this.take("]")) {
      do {
        value.value.push(this.readValue(value, value.value.length));
      } while (this.take(","));
      if (!this.take("]")) this.fail("not JSON", value);
    }
    --this.levels;
  }

  readString(value) {
    value.kind = "string";
    value.value = this.readText(value);
  }

  // A text in quotation marks; a half of a surrogate pair alone is none.
  readText(value) {
    let text = "";
    ++this.at;
    for (;;) {
      text += this.match(JSON_PLAIN)[0];
      if (text.length > MOST_TEXT) this.fail("a string of more than 2^20 bytes", value);
      const next = this.text[this.at++];
      if (next === '"') break;
      if (next !== "\\") this.fail("not JSON", value);
      text += this.readEscape(value);
    }
    if (/[\ud800-\udbff](?![\udc00-\udfff])|(?<![\ud800-\udbff])[\udc00-\udfff]/.test(text)) {
      this.fail("not JSON", value);
    }
    return text;
  }

  readEscape(value) {
    const letter = this.text[this.at++];
    if (letter !== "u") {
      if (!Object.hasOwn(JSON_ESCAPES, letter ?? "")) this.fail("not JSON", value);
      return JSON_ESCAPES[letter];
    }
    const digits = this.text.slice(this.at, this.at + 4);
    if (!/^[0-9a-fA-F]{4}$/.test(digits)) this.fail("not JSON", value);
    this.at += 4;
    return String.fromCharCode(parseInt(digits, 16));
  }

  readNumber(value) {
    const found = this.match(JSON_NUMBER);
    if (!found) this.fail("not JSON", value);
    value.kind = "number";
    value.value = found[0];
    value.isWhole = found[1] === undefined && found[2] === undefined;
    if (found[0].length > MOST_CHARACTERS) this.fail("a number of more than 4096 characters", value);
    if (!value.isWhole || found[0].length > 300) {
      if (binary64OfText(found[0]) === null) this.fail("beyond the range of binary64", value);
    }
  }

  readWord(value) {
    const found = this.match(JSON_WORD);
    if (!found) this.fail("not JSON", value);
    value.kind = found[0] === "null" ? "null" : "boolean";
    value.value = found[0];
  }
}

// The binary64 nearest to the decimal, as a fraction; null where there is none, or where it is 0 and the
// decimal is not.
function binary64OfText(text) {
  const [, minus, digits, places = "", exponent = "0"] = /^(-?)([0-9]+)(?:\.([0-9]+))?(?:[eE]([-+]?[0-9]+))?$/.exec(text);
  const n = BigInt(digits + places);
  if (n === 0n) return ZERO;
  const e = Number(exponent) - places.length;
  // With 4096 digits at most such a number is far beyond the range, or far below it.
  if (Math.abs(e) > 10000) return null;
  const exact = e >= 0 ? Fraction.whole(n * 10n ** BigInt(e)) : new Fraction(n, 5n ** BigInt(-e), -e);
  const nearest = nearestBinary64(exact);
  if (nearest === null || nearest.n === 0n) return null;
  return minus ? nearest.negative() : nearest;
}

// The value of an exact string: decimal, fraction or hexadecimal float.
function exactOfText(text, more) {
  if (text.length > MOST_CHARACTERS) invalid("an exact number of more than 4096 characters", more);
  const signed = (x) => (text[0] === "-" ? x.negative() : x);
  const ratio = /^-?([0-9]+)\/([0-9]+)$/.exec(text);
  if (ratio) {
    if (BigInt(ratio[2]) === 0n) invalid("a fraction with denominator zero", more);
    return signed(Fraction.ratio(BigInt(ratio[1]), BigInt(ratio[2])));
  }
  const hex = /^-?0[xX]([0-9a-fA-F]+)(?:\.([0-9a-fA-F]+))?(?:[pP]([-+]?[0-9]{1,9}))?$/.exec(text);
  const decimal = /^-?([0-9]+)(?:\.([0-9]+))?(?:[eE]([-+]?[0-9]{1,9}))?$/.exec(text);
  if (!hex && !decimal) invalid("not an exact number", more);
  const [, digits, places = "", exponent = "0"] = hex ?? decimal;
  if (Math.abs(Number(exponent)) > (hex ? 1200 : 400)) invalid("the exponent of an exact number", more);
  const whole = Fraction.whole(BigInt((hex ? "0x" : "") + digits + places));
  return signed(whole.times(power(hex ? 2 : 10, Number(exponent) - (hex ? 4 : 1) * places.length)));
}
