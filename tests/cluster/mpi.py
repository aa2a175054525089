#!/usr/bin/env python3
"""packaging/cluster/certify_mpi.py for real: four ranks give the report of one process, also with an index, of a history that is
false, after a rank was killed in the middle, and where certificates of other bytes or options are there. A rank that
fails ends the job.

usage: mpi.py PROGRAM      (build/voroproof)
"""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

DRIVER = pathlib.Path(__file__).resolve().parents[2] / "packaging" / "cluster" / "certify_mpi.py"
PYTHON = "/usr/bin/python3"  # Debian's, which has Debian's mpi4py
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_hwloc_base_binding_policy": "none"}
SHARDS = 12


def skip_without_tools():
    if shutil.which("mpirun") is None:
        print("skipped: no mpirun")
        sys.exit(77)
    if subprocess.run([PYTHON, "-c", "import mpi4py"], capture_output=True, check=False).returncode != 0:
        print("skipped: no mpi4py")
        sys.exit(77)


def start(folder, program, history, *options):
    return subprocess.Popen(
        ["mpirun", "-n", "4", PYTHON, DRIVER, "--program", program, "--shards", str(SHARDS), "--report",
         "mpi.json", "a.scene.json", history, *options], cwd=folder, env=ENVIRONMENT, stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, text=True)


def finish(job, folder, wanted, keep=False):
    """With `keep` the certificates of the shards stay."""
    out, err = job.communicate()
    code, last, report = wanted
    assert job.returncode == code, (job.returncode, out, err)
    assert out.splitlines()[-1] == last, (out, err)
    assert (folder / "mpi.json").read_bytes() == report
    (folder / "mpi.json").unlink()
    if not keep:
        shutil.rmtree(folder / "mpi.json.shards")


def of_one_process(folder, program, history, *options):
    """Exit code, last line and report."""
    done = subprocess.run([program, "certify", "a.scene.json", history, "--truth", "recorded", "--report", "one.json",
                           *options],
                          cwd=folder, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout.splitlines()[-1], (folder / "one.json").read_bytes()


def ranks_of(job):
    """The processes that mpirun has started."""
    return [int(pid) for pid in pathlib.Path(f"/proc/{job.pid}/task/{job.pid}/children").read_text().split()]


def kill_a_rank(job, folder):
    """Kills the last rank once a certificate is there, and before all are."""
    shards = folder / "mpi.json.shards"
    while not list(shards.glob("*.json")):
        assert job.poll() is None, job.communicate()
        time.sleep(0.01)
    os.kill(ranks_of(job)[-1], signal.SIGKILL)
    out, err = job.communicate()
    assert job.returncode != 0, (out, err)
    assert not (folder / "mpi.json").exists()
    assert 0 < len(list(shards.glob("*.json"))) < SHARDS


def without_a_flip(history):
    lines = history.splitlines(keepends=True)
    flip = next(k for k in range(len(lines) // 2, len(lines)) if "flip" in lines[k])
    return "".join(lines[:flip] + lines[flip + 1:])


def check_stale_certificates(folder, program):
    """Certificates of the right history are there when it is replaced, and some with other options."""
    history = folder / "c.history.jsonl"
    right = (folder / "a.history.jsonl").read_text()
    history.write_text(right)
    finish(start(folder, program, history.name), folder, of_one_process(folder, program, history.name), keep=True)
    options = ("--tolerance", "1e-7")
    finish(start(folder, program, history.name, *options), folder,
           of_one_process(folder, program, history.name, *options), keep=True)
    history.write_text(without_a_flip(right))
    wrong = of_one_process(folder, program, history.name, *options)
    assert wrong[0] == 1
    finish(start(folder, program, history.name, *options), folder, wrong)


def check_failing_rank(folder):
    job = start(folder, str(folder / "no-such-program"), "a.history.jsonl")
    out, err = job.communicate()
    assert job.returncode != 0 and "no-such-program" in err, (job.returncode, out, err)
    shutil.rmtree(folder / "mpi.json.shards")


def main():
    skip_without_tools()
    program = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for command in ("generate reference --n 30 --seed 3 --density 0.2 --horizon 1000 -o a.scene.json",
                        "simulate a.scene.json -o a.history.jsonl"):
            subprocess.run([program, *command.split()], cwd=folder, check=True, capture_output=True)
        right = of_one_process(folder, program, "a.history.jsonl")
        assert right[0] == 0
        finish(start(folder, program, "a.history.jsonl"), folder, right)
        subprocess.run([program, "index", "a.scene.json", "a.history.jsonl"], cwd=folder, check=True, capture_output=True)
        finish(start(folder, program, "a.history.jsonl", "--index", "a.history.jsonl.index"), folder, right)

        (folder / "b.history.jsonl").write_text(without_a_flip((folder / "a.history.jsonl").read_text()))
        wrong = of_one_process(folder, program, "b.history.jsonl")
        assert wrong[0] == 1
        finish(start(folder, program, "b.history.jsonl"), folder, wrong)

        check_stale_certificates(folder, program)
        check_failing_rank(folder)

        # The last shard takes longer than the test waits: so not all are there, however fast the others are.
        slow = folder / "slow"
        slow.write_text(f'#!/bin/sh\ncase "$*" in *"--part {SHARDS}/{SHARDS} "*) exec sleep 1000 ;; esac\n'
                        f'exec "{program}" "$@"\n')
        slow.chmod(0o755)
        kill_a_rank(start(folder, str(slow), "a.history.jsonl"), folder)
        finish(start(folder, program, "a.history.jsonl"), folder, right)
    print("four ranks and one process agree")


if __name__ == "__main__":
    main()
