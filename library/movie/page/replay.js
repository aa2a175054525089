"use strict";
// The diagram after so many events: the initial one, and the flips of the history as it claims
// them. Nothing here looks at positions.

class Replay {
  constructor(data) {
    this.data = data;
    this.applied = 0;
    // From this event on there is no diagram, because of `fault`, or because none is to be shown; the
    // number of events if never.
    this.broken = data.events + 1;
    this.fault = null;
    if (data.facts.noDiagram === undefined) this.begin();
    else this.broken = 0;
    this.halfOf = new Int32Array(data.events);  // by flip, once it has been played
    this.played = 0;    // number of events that have been played once
    this.resolved = 0;  // flips whose edge was found with its third generators exchanged
    if (this.diagram) this.colouring = colouring(this.diagram);
    // Through the whole history once: to know where it breaks.
    this.moveTo(data.events);
    this.moveTo(0);
  }

  begin() {
    const { data } = this, missing = data.facts.noInitial;
    try {
      if (missing !== undefined) throw new Error(missing);
      this.diagram = new Diagram(data.count, data.initial);
    } catch (error) {
      this.breakAt(0, `there is no initial diagram: ${error.message}`);
    }
  }

  breakAt(count, reason) {
    this.broken = count;
    this.fault = reason;
  }

  // Whether the history has a diagram where the replay stands.
  get whole() {
    return this.applied < this.broken;
  }

  // To just after the first `count` events.
  moveTo(count) {
    const last = Math.min(count, this.broken - 1);  // beyond that there are no flips to make
    let at = Math.min(this.applied, this.broken - 1);
    for (; at < last && at < this.broken - 1; ++at) this.forward(at);
    for (; at > last; --at) this.backward(at - 1);
    this.applied = count;
  }

  forward(event) {
    if (this.data.kinds[event] !== FLIP) return;
    if (event >= this.played) {
      const [l, r, s, e] = this.data.sitesOf(event);
      let h = this.diagram.find(l, r, s, e);
      if (h < 0) {  // a name without orientation (docs/formats.md, section 8)
        h = this.diagram.find(l, r, e, s);
        if (h >= 0) ++this.resolved;
      }
      if (h < 0) {
        this.breakAt(event + 1, `the diagram has no edge ${names(l, r, s, e)} to flip`);
        return;
      }
      if (s === e) {
        this.breakAt(event + 1, `the edge ${names(l, r, s, e)} cannot flip`);
        return;
      }
      this.halfOf[event] = h;
      this.played = event + 1;
    }
    this.diagram.flip(this.halfOf[event]);
  }

  backward(event) {
    if (this.data.kinds[event] === FLIP) this.diagram.unflip(this.halfOf[event]);
  }
}
