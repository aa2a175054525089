#!/usr/bin/env python3
"""packaging/cluster/certify_array.sh and packaging/cluster/Snakefile under a Slurm of one node on this machine: the array gives the report
of one process, also where tasks were lost, and the workflow that of each of many scenes. Where the history is replaced,
or the options are others, nothing that is there counts as done.

usage: slurm.py PROGRAM      (build/voroproof)

slurmctld, slurmd and munged run in a folder of their own, on ports of their own.
"""

import contextlib
import getpass
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time

CLUSTER = pathlib.Path(__file__).resolve().parents[2] / "packaging" / "cluster"
TOOLS = ["slurmctld", "slurmd", "munged", "sbatch", "scancel", "snakemake"]
SHARDS = 6

CONFIGURATION = """\
ClusterName=one
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmdPort={node}
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def skip(why):
    print(f"skipped: {why}")
    sys.exit(77)


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


@contextlib.contextmanager
def slurm(folder):
    """A Slurm of this node; what it yields are the environment of its commands."""
    for name in ("munge", "state", "spool"):
        (folder / name).mkdir()
    folder.chmod(0o755)
    munge = folder / "munge"
    (munge / "key").write_bytes(os.urandom(1024))
    (munge / "key").chmod(0o400)
    configuration = folder / "slurm.conf"
    configuration.write_text(CONFIGURATION.format(folder=folder, host=socket.gethostname().partition(".")[0],
                                                  user=getpass.getuser(), controller=free_port(), node=free_port()))
    environment = {**os.environ, "SLURM_CONF": str(configuration)}
    daemons = []

    def run(*command):
        with open(folder / "daemons.out", "a", encoding="utf-8") as out:
            daemons.append(subprocess.Popen(command, env=environment, stdout=out, stderr=out))

    try:
        run("munged", "-F", f"--key-file={munge}/key", f"--socket={munge}/socket", f"--pid-file={munge}/pid",
            f"--log-file={munge}/log", f"--seed-file={munge}/seed")
        while not (munge / "socket").exists():
            if daemons[0].poll() is not None:
                skip("munged does not run here: " + (folder / "daemons.out").read_text())
            time.sleep(0.05)
        run("slurmctld", "-D", "-f", str(configuration))
        run("slurmd", "-D", "-f", str(configuration))
        while "idle" not in subprocess.run(["sinfo", "-h", "-o", "%t"], env=environment, capture_output=True, text=True,
                                           check=False).stdout:
            if any(daemon.poll() is not None for daemon in daemons):
                logs = "".join(path.read_text() for path in folder.glob("*.log"))
                skip("slurmctld or slurmd does not run here: " + logs[-500:])
            time.sleep(0.1)
        yield environment
    finally:
        for daemon in reversed(daemons):
            daemon.terminate()
            daemon.wait()


def one_process(folder, program, name, *options):
    subprocess.run([program, "certify", f"{name}.scene.json", f"{name}.history.jsonl", "--truth", "recorded", "--report",
                    "one.json", *options], cwd=folder, capture_output=True, check=False)
    return (folder / "one.json").read_bytes()


def array(folder, program, environment, *options, more=()):
    """Submits the array and waits for it."""
    return subprocess.run(
        ["sbatch", "--wait", f"--array=1-{SHARDS}", "--output=/dev/null", *options, CLUSTER / "certify_array.sh",
         "a.scene.json", "a.history.jsonl", "a.shards", *more],
        cwd=folder, env={**environment, "VOROPROOF": program}, capture_output=True, text=True, check=False)


def without_a_flip(history):
    lines = history.splitlines(keepends=True)
    flip = next(k for k in range(len(lines) // 2, len(lines)) if "flip" in lines[k])
    return "".join(lines[:flip] + lines[flip + 1:])


def merged(folder, program):
    """Exit code and report of all certificates."""
    done = subprocess.run([program, "certify", "--report", "merged.json", "--merge",
                           *sorted((folder / "a.shards").glob("*.json"))], cwd=folder, capture_output=True, check=False)
    return done.returncode, (folder / "merged.json").read_bytes()


def check_array(folder, program, environment):
    report = one_process(folder, program, "a")
    # One task is lost on its way, and the array given again.
    lost = folder / "lost"
    lost.write_text(f'#!/bin/sh\n[ $SLURM_ARRAY_TASK_ID -ne 3 ] || kill -9 $$\nexec "{program}" "$@"\n')
    lost.chmod(0o755)
    assert array(folder, str(lost), environment).returncode != 0
    certificates = sorted((folder / "a.shards").glob(f"*-of-{SHARDS}.json"))
    assert len(certificates) == SHARDS - 1, certificates
    times = [path.stat().st_mtime_ns for path in certificates]
    done = array(folder, program, environment)
    assert done.returncode == 0, done.stderr
    assert times == [path.stat().st_mtime_ns for path in certificates]
    assert merged(folder, program) == (0, report)
    # With other options, then of another history.
    options = ("--tolerance", "1e-7")
    assert array(folder, program, environment, more=options).returncode == 0
    assert merged(folder, program) == (0, one_process(folder, program, "a", *options))
    history = folder / "a.history.jsonl"
    history.write_text(without_a_flip(history.read_text()))
    assert array(folder, program, environment, more=options).returncode == 0
    assert merged(folder, program) == (1, one_process(folder, program, "a", *options))


def check_workflow(folder, program, environment):
    """Three scenes, of one of which the history lacks a flip."""
    many = folder / "many"
    many.mkdir()
    for seed in ("1", "2", "3"):
        subprocess.run([program, "generate", "reference", "--n", "12", "--seed", seed, "--density", "0.2", "--horizon",
                        "60", "-o", f"s{seed}.scene.json"], cwd=many, check=True)
    subprocess.run([program, "simulate", "s2.scene.json", "-o", "s2.history.jsonl", "--quiet"], cwd=many, check=True,
                   capture_output=True)
    # It is older than its scene, and still the one to be judged.
    (many / "s2.history.jsonl").write_text(without_a_flip((many / "s2.history.jsonl").read_text()))
    os.utime(many / "s2.history.jsonl", (0, 0))
    run_workflow(folder, program, environment, ["CERTIFIED", "REFUTED", "CERTIFIED"])
    # A replaced history that looks as old as the one before it.
    history = many / "s3.history.jsonl"
    times = history.stat()
    history.write_text(without_a_flip(history.read_text()))
    os.utime(history, ns=(times.st_atime_ns, times.st_mtime_ns))
    run_workflow(folder, program, environment, ["CERTIFIED", "REFUTED", "REFUTED"])


def run_workflow(folder, program, environment, verdicts):
    many = folder / "many"
    done = subprocess.run(
        ["snakemake", "-s", CLUSTER / "Snakefile", "--directory", many, "--jobs", "8", "--latency-wait", "30",
         "--max-jobs-per-second", "20", "--max-status-checks-per-second", "20", "--cluster",
         "sbatch --output=/dev/null", "--config", f"program={program}", "shards=2"],
        env={**environment, "HOME": str(folder)}, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-3000:]
    table = [line.split("\t")[:2] for line in (many / "verdicts.tsv").read_text().splitlines()]
    assert table == [[f"s{k + 1}", verdict] for k, verdict in enumerate(verdicts)], table
    for name, _ in table:
        assert (many / f"{name}.report.json").read_bytes() == one_process(many, program, name), name


def main():
    for tool in TOOLS:
        if shutil.which(tool) is None:
            skip(f"no {tool}")
    program = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        with slurm(folder) as environment:
            for command in ("generate reference --n 30 --seed 3 --density 0.2 --horizon 1000 -o a.scene.json",
                            "simulate a.scene.json -o a.history.jsonl --quiet"):
                subprocess.run([program, *command.split()], cwd=folder, check=True, capture_output=True)
            check_array(folder, program, environment)
            check_workflow(folder, program, environment)
    print("an array, a workflow and one process agree")


if __name__ == "__main__":
    main()
