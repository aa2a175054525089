"""Altered histories for testing a judge: small lies, and whole worlds with a wrong law.

Command: mutants.py SCENE HISTORY SEED KIND OUT writes one altered history of the named kind to OUT."""
import json
import math
import random
import sys

from billiard import Scene
from engine import Degenerate, World, history_bytes, history_rows

TRIES = 8    # choices to go through until an alteration changes something


def is_collision(event):
    return "collide" in event


def is_pair(event):
    return is_collision(event) and event["collide"][0] >= 0


def is_wall(event):
    return is_collision(event) and event["collide"][0] < 0


def pick(rng, events, wanted=lambda event: True):
    """The place of a random event of the wanted sort, or None."""
    places = [n for n, event in enumerate(events) if wanted(event)]
    return rng.choice(places) if places else None


def velocities(event):
    """The vectors in an event that may be altered, as (list that holds it, index)."""
    if not is_collision(event):
        return [(event, "v")]
    return [(event["v"], n) for n in (0, 1) if event["v"][n] is not None]


# Small lies: each takes the scene, the events (its own copy) and a random generator; None if it cannot be told.

def delete_collision(scene, events, rng):
    n = pick(rng, events, is_collision)
    return None if n is None else events[:n] + events[n + 1:]


def delete_maneuver(scene, events, rng):
    n = pick(rng, events, lambda event: not is_collision(event))
    return None if n is None else events[:n] + events[n + 1:]


def shift(by):
    def change(scene, events, rng):
        n = pick(rng, events)
        if n is None:
            return None
        low = events[n - 1]["t"] if n else 0.0
        high = events[n + 1]["t"] if n + 1 < len(events) else float(scene.horizon)
        t = events[n]["t"] + rng.choice([-by, by])
        if not low <= t <= high:
            return None
        events[n]["t"] = t
        return events
    return change


def alter_velocity(change_vector):
    def change(scene, events, rng):
        n = pick(rng, events, lambda event: velocities(event))
        if n is None:
            return None
        holder, index = rng.choice(velocities(events[n]))
        holder[index] = change_vector(holder[index], rng)
        return events
    return change


def scaled(v, rng):
    factor = 1 + rng.choice([-1e-3, 1e-3])
    return [factor * x for x in v]


def rotated(v, rng):
    a, b = rng.sample(range(len(v)), 2)
    angle, result = rng.choice([-1e-3, 1e-3]), list(v)
    result[a] = math.cos(angle) * v[a] - math.sin(angle) * v[b]
    result[b] = math.sin(angle) * v[a] + math.cos(angle) * v[b]
    return result


def swap_velocities(scene, events, rng):
    n = pick(rng, events, lambda event: is_pair(event) and None not in event["v"])
    if n is None:
        return None
    events[n]["v"].reverse()
    return events


def wrong_partner(scene, events, rng):
    n = pick(rng, events, is_collision)
    if n is None:
        return None
    i, j = events[n]["collide"]
    others = [k for k, d in enumerate(scene.disks) if k not in (i, j) and not d.fixed and (i >= 0 or k != j)]
    if not others:
        return None
    k = rng.choice(others)
    if i >= 0 and k < i:
        # The pair stays sorted: the one that is kept comes second.
        events[n]["collide"] = [k, i]
        events[n]["v"] = [events[n]["v"][1] or events[n]["v"][0], events[n]["v"][0]]
    else:
        events[n]["collide"] = [i, k]
        events[n]["v"][1] = events[n]["v"][1] or events[n]["v"][0]
    return events


def wrong_image(scene, events, rng):
    axes = [axis for axis, side in enumerate(scene.sides) if side is not None]
    n = pick(rng, events, lambda event: "image" in event)
    if n is None or not axes:
        return None
    events[n]["image"][rng.choice(axes)] += rng.choice([-1, 1])
    return events


def wrong_wall(scene, events, rng):
    n = pick(rng, events, is_wall)
    others = [-1 - w for w in range(len(scene.walls)) if n is not None and -1 - w != events[n]["collide"][0]]
    if not others:
        return None
    events[n]["collide"][0] = rng.choice(others)
    return events


def extra_collision(scene, events, rng):
    movable = [k for k, d in enumerate(scene.disks) if not d.fixed]
    walls = 1 if scene.circle else len(scene.walls)
    partners = list(range(-walls, len(scene.disks)))
    j = rng.choice(movable)
    i = rng.choice([k for k in partners if k != j] or [None])
    if i is None:
        return None
    i, j = min(i, j), max(i, j)
    t = rng.uniform(0, float(scene.horizon))
    world = World(scene)
    for event in events:
        if event["t"] < t:
            follow(world, event, scene)
    v = [None if k < 0 or scene.disks[k].fixed else world.bodies[k].velocity(t) for k in (i, j)]
    extra = {"t": t, "collide": [i, j], "v": v}
    if scene.periodic and i >= 0:
        extra["image"] = [0] * scene.dimension
    return sorted(events + [extra], key=lambda event: event["t"])


def follow(world, event, scene):
    """Lets the disks of a world turn as an event says."""
    if not is_collision(event):
        world.bodies[event["maneuver"]].turn(event["t"], event["v"])
        return
    for k, v in zip(event["collide"], event["v"]):
        if v is not None:
            world.bodies[k].turn(event["t"], v)


def drop_tail(scene, events, rng):
    return events[:-rng.randint(1, min(3, len(events)))] if events else None


# Consistent wrong worlds: the engine runs again, without something.

def rerun(scene, ignore=lambda pair, image: False, prepare=lambda world: None, lag=0.0):
    world = World(scene, ignore, lag)
    prepare(world)
    try:
        return world.run(float(scene.horizon), 400)
    except (Degenerate, ZeroDivisionError):
        return None


def ignore_wall(scene, events, rng):
    walls = 1 if scene.circle else len(scene.walls)
    if not walls:
        return None
    wall = -rng.randint(1, walls)
    return rerun(scene, lambda pair, image: pair[0] == wall)


def ignore_image(scene, events, rng):
    axes = [axis for axis, side in enumerate(scene.sides) if side is not None]
    if not axes:
        return None
    axis, direction = rng.choice(axes), rng.choice([-1, 1])
    return rerun(scene, lambda pair, image: image is not None and image[axis] * direction > 0)


def ignore_pair(scene, events, rng):
    if len(scene.disks) < 2:
        return None
    ignored = tuple(sorted(rng.sample(range(len(scene.disks)), 2)))
    return rerun(scene, lambda pair, image: pair == ignored)


def wrong_mass(scene, events, rng):
    body = rng.choice([k for k, d in enumerate(scene.disks) if not d.fixed])

    def prepare(world):
        world.bodies[body].m *= rng.choice([0.5, 1.01, 2])
    return rerun(scene, prepare=prepare)


def ignore_growth(scene, events, rng):
    def prepare(world):
        for body in world.bodies:
            body.g = 0.0
    return rerun(scene, prepare=prepare) if any(d.growth for d in scene.disks) else None


def ignore_gravity(scene, events, rng):
    def prepare(world):
        for body in world.bodies:
            body.a = [0.0] * scene.dimension
    return rerun(scene, prepare=prepare) if any(scene.gravity) else None


def ignore_wall_speed(scene, events, rng):
    def prepare(world):
        world.walls = [(n, h, 0.0, e) for n, h, _, e in world.walls]
    return rerun(scene, prepare=prepare) if any(w.speed for w in scene.walls) else None


def lag(by):
    """Not always wrong: by less than the tolerance every collision may come early or late."""
    def change(scene, events, rng):
        return rerun(scene, lag=rng.choice([-by, by]))
    return change


def wrong_counts(scene, events, rng):
    return events      # the end line is altered in mutate


KINDS = {"delete-collision": delete_collision, "delete-maneuver": delete_maneuver, "shift-1e-3": shift(1e-3),
         "shift-3e-6": shift(3e-6), "scale-velocity": alter_velocity(scaled),
         "rotate-velocity": alter_velocity(rotated), "swap-velocities": swap_velocities,
         "wrong-partner": wrong_partner, "wrong-image": wrong_image, "wrong-wall": wrong_wall,
         "extra-collision": extra_collision, "drop-tail": drop_tail, "wrong-counts": wrong_counts,
         "ignore-wall": ignore_wall, "ignore-image": ignore_image, "ignore-pair": ignore_pair,
         "wrong-mass": wrong_mass, "ignore-growth": ignore_growth, "ignore-gravity": ignore_gravity,
         "ignore-wall-speed": ignore_wall_speed,
         "lag-5e-7": lag(5e-7), "lag-2e-6": lag(2e-6)}


def mutate(scene, rows, seed, kind):
    """Rows of an altered history with a fitting end line, or None if the kind does not fit. rows stay as they are."""
    rng = random.Random(f"mutant {seed} {kind}")
    for _ in range(TRIES):
        events = KINDS[kind](scene, json.loads(json.dumps(rows[1:-1])), rng)
        if events is None or (events == rows[1:-1] and kind != "wrong-counts"):
            continue
        result = history_rows(scene, events)
        if kind == "wrong-counts":
            result[-1]["end"][rng.choice(["collisions", "maneuvers"])] += 1
        if rng.random() < 0.5:
            # Without centres a judge has to find the lie from times and velocities alone.
            for event in events:
                event.pop("p", None)
        return result
    return None


def main():
    scene_path, history_path, seed, kind, out = sys.argv[1:]
    with open(scene_path, "rb") as file:
        scene = Scene(file.read())
    with open(history_path, encoding="utf-8") as file:
        rows = [json.loads(row) for row in file]
    result = mutate(scene, rows, int(seed), kind)
    if result is None:
        sys.exit(f"no {kind} fits this history")
    with open(out, "wb") as file:
        file.write(history_bytes(result))


if __name__ == "__main__":
    main()
