"""The output of faulty implementations. Each class is a way to be wrong that was seen in engines, as an edit
of the exact history or as the exact history of what such an engine takes the scene for."""
from copy import deepcopy
from dataclasses import dataclass
from fractions import Fraction

from degenerate.history import History, canonical, flip, flipped

# Every class, and what an implementation does that writes so.
CLASSES = {
    "tie-drops-flip": "of several flips at one instant one is lost: after the first, the root of the "
                      "other is taken for the one just used",
    "tie-out-of-order": "flips of one instant are written in an order in which they cannot happen",
    "wrong-order": "two events are exchanged that do not commute",
    "near-roots-merged": "two roots nearer than a tolerance are taken for one, or for none",
    "flip-missed": "a real flip is not seen",
    "even-root-taken": "an edge that touches cotangency and turns back is flipped",
    "even-root-there-and-back": "at an even root an edge is flipped and flipped back",
    "noise-taken": "rounding errors of a polynomial that is constant, or zero, are taken for a root",
    "shadow-taken": "the flip of another edge of the same four generators is taken for one of this edge",
    "wrong-edge-of-four": "of the edges of the same four generators the wrong one is flipped",
    "smallest-id-enlarged": "permanent cotangency is resolved by the wrong id",
    "ties-left-alone": "an edge that stays cotangent is left as it was found",
    "input-moved": "the input is moved a little so that nothing is degenerate",
    "radii-taken-for-equal": "radii nearer than a tolerance are taken for equal",
    "rounded-time": "times are found to a tolerance only",
    "contact-missed": "a contact is not seen",
    "graze-taken-for-hit": "a tangential contact, or a near miss, is taken for a collision",
    "second-collision-dropped": "of several collisions at one instant only the first is made",
    "collision-order": "simultaneous collisions that share a disk are made in another order",
    "wrong-response": "velocities after a contact are not those of the law",
    "cancelled-event-kept": "an event that a maneuver of the same instant cancels happens all the same",
    "maneuver-lost": "a maneuver is not carried out",
    "maneuver-first": "a maneuver is carried out before a collision of the same instant",
    "stops-early": "the run ends early and claims the whole horizon",
}


@dataclass
class Wrong:
    name: str  # a key of CLASSES
    kind: str  # the fault that `certify` must name
    make: object  # (History, Simulator) -> History
    truth: str = "exact"
    awaits: str = None  # the feature that `certify` needs before it can refute this; left out until then

    def __post_init__(self):
        if self.name not in CLASSES:
            raise ValueError(f"{self.name}: no such class")


def edited(name, kind, edit, truth="exact"):
    """By an edit of the list of events."""
    def make(history, _):
        return history.with_events(edit(history, deepcopy(history.events)))
    return Wrong(name, kind, make, truth)


def dropped(what, k=0, name="flip-missed", kind="missing event", truth="exact"):
    """Without the k-th flip, collision or maneuver (k may count from the end)."""
    def edit(history, events):
        del events[history.indices(what)[k]]
        return events
    return edited(name, kind, edit, truth)


def drops_tied_flip(tie=0, k=-1, kind="missing event"):
    """Without the k-th flip of the tie-th instant that has several."""
    def edit(history, events):
        del events[history.ties("flip")[tie][k]]
        return events
    return edited("tie-drops-flip", kind, edit)


def drops_tied_collision(tie=0, k=-1, kind="missing event"):
    def edit(history, events):
        del events[history.ties("collide")[tie][k]]
        return events
    return edited("second-collision-dropped", kind, edit)


def exchanged(k, j, name="tie-out-of-order", kind="edge not present", what="flip"):
    """The k-th and the j-th flip exchange places, not times."""
    def edit(history, events):
        a, b = history.indices(what)[k], history.indices(what)[j]
        events[a], events[b] = (events[b] | {"t": events[a]["t"]}, events[a] | {"t": events[b]["t"]})
        return events
    return edited(name, kind, edit)


def reversed_tie(tie=0, kind="edge not present"):
    """The flips of an instant from last to first."""
    def edit(history, events):
        group = history.ties("flip")[tie]
        for k, j in zip(group, reversed([events[k] for k in group])):
            events[k] = j
        return events
    return edited("tie-out-of-order", kind, edit)


def place(events, t):
    """Where an event of time t goes: after those of this time."""
    return next((k for k, e in enumerate(events) if e["t"] > t), len(events))


def inserted_flip(t, quad, name, kind="spurious event", back=False):
    def edit(_, events):
        k = place(events, float(t))
        events.insert(k, {"t": float(t), "flip": canonical(quad)})
        if back:
            events.insert(k + 1, {"t": float(t), "flip": flipped(quad)})
        return events
    return edited(name, kind, edit)


def noise(t, k=0, kind="spurious event"):
    """At t, where nothing happens, the k-th edge that could flip is claimed to."""
    def edit(history, events):
        before = place(events, float(t))
        able = [q for q in history.edges_before(before) if q[2] != q[3]]
        events.insert(before, {"t": float(t), "flip": able[k]})
        return events
    return edited("noise-taken", kind, edit)


def kept_cotangent(t, quad, kind="spurious event"):
    return inserted_flip(t, quad, "even-root-taken", kind)


def inserted_hit(t, i, j, scene, kind="spurious event", name="graze-taken-for-hit"):
    """A collision of disks on their first straight path, with velocities as if nothing happened."""
    def edit(_, events):
        def place_of(k):
            return None if k < 0 else [float(x) for x in scene.disks[k].at(Fraction(t))]

        def velocity_of(k):
            return None if k < 0 else [float(scene.disks[k].vx), float(scene.disks[k].vy)]
        events.insert(place(events, float(t)),
                      {"t": float(t), "collide": [i, j], "v": [velocity_of(i), velocity_of(j)],
                       "p": [place_of(i), place_of(j)]})
        return events
    return edited(name, kind, edit)


def drops_pair(k=0, j=1, name="near-roots-merged", kind="missing event"):
    """Without the k-th and the j-th flip."""
    def edit(history, events):
        for index in sorted((history.indices("flip")[k], history.indices("flip")[j]), reverse=True):
            del events[index]
        return events
    return edited(name, kind, edit)


def late(k, by, what="flip", kind="wrong time", name="rounded-time"):
    """The k-th flip, collision or maneuver is claimed for another time; events passed move along."""
    def edit(history, events):
        index = history.indices(what)[k]
        t = events[index]["t"] + float(by)
        events[index]["t"] = t
        for other in events[index + 1:]:
            other["t"] = max(other["t"], t)
        for other in events[:index]:
            other["t"] = min(other["t"], t)
        return events
    return edited(name, kind, edit)


def wrong_velocity(k, change, kind="wrong response", truth="exact"):
    """The k-th collision leaves with `change` of its velocities."""
    def edit(history, events):
        e = events[history.indices("collide")[k]]
        e["v"] = change(e["v"])
        return events
    return edited("wrong-response", kind, edit, truth)


def other_initial(quad, name="smallest-id-enlarged"):
    """The initial diagram with the edge flipped."""
    def make(history, _):
        header = history.header | {"initial": flip(history.header["initial"], quad)}
        return History(header, history.events, history.last)
    return Wrong(name, "wrong initial diagram", make)


def cut_tail(keep, kind="missing event"):
    """Only the first events, and the last line claims the horizon."""
    return edited("stops-early", kind, lambda history, events: events[:keep])


def of_scene(name, kind, change, truth="exact", awaits=None):
    """The exact history of another scene, claimed for this one."""
    def make(history, simulate):
        scene = deepcopy(simulate.scene)
        other = simulate(change(scene) or scene)
        return History(other.header | {"scene_sha256": history.header["scene_sha256"]},
                       other.events, other.last)
    return Wrong(name, kind, make, truth, awaits)


def renumbered(name, kind, image, truth="exact"):
    """The exact history with the ids of docs/formats.md exchanged for others in all rules: disk i is
    treated as if it were disk image[i]."""
    def make(history, simulate):
        scene = deepcopy(simulate.scene)
        back = {-1: -1} | {image[i]: i for i in range(len(image))}
        scene.disks = [simulate.scene.disks[back[i]] for i in range(len(image))]
        scene.maneuvers = [(t, image[i], vx, vy) for t, i, vx, vy in scene.maneuvers]
        other = simulate(scene)
        events = []
        for e in other.events:
            e = dict(e)
            if "flip" in e:
                e["flip"] = canonical([back[g] for g in e["flip"]])
            elif "collide" in e:
                i, j = (back[g] for g in e["collide"])
                if i > j:
                    i, j = j, i
                    e["v"], e["p"] = e["v"][::-1], e["p"][::-1]
                e["collide"] = [i, j]
            else:
                e["maneuver"] = back[e["maneuver"]]
            events.append(e)
        initial = sorted(canonical([back[g] for g in q]) for q in other.header["initial"])
        return History(history.header | {"initial": initial}, events, other.last)
    return Wrong(name, kind, make, truth)


def backwards(n):
    """The numbering from last to first."""
    return list(range(n))[::-1]


def enlarges_smallest(n, kind="wrong initial diagram"):
    return renumbered("smallest-id-enlarged", kind, backwards(n))


def other_collision_order(n, kind):
    return renumbered("collision-order", kind, backwards(n))
