#!/usr/bin/env python3
"""Certifies one history by many processes: voroproof certify --part, dealt out over MPI, and --merge.

usage: mpirun -n RANKS python3 packaging/cluster/certify_mpi.py [--program VOROPROOF] [--shards N] --report REPORT
           SCENE HISTORY [OPTIONS OF certify...]

Every rank certifies shards, one at a time; rank 0 deals them, too: a rank that is done gets the next. The
files must have the same names on all nodes. The certificates go to REPORT.shards/, each whole or not at all:
given again after a rank, a node or the whole job was lost, the same command takes up what is there, where that is of
these bytes, these options and this version. Output and exit code are those of certify --merge; 2 where a shard could
not be certified at all. A rank that fails ends the job.
"""

import argparse
import ctypes
import pathlib
import signal
import subprocess
import sys
import time
import traceback

from mpi4py import MPI

DEALER = 0
ASK, DEAL = 1, 2
PATIENCE = 0.005  # seconds between two looks; MPI's own waiting would take a processor
VERDICTS = (0, 1, 3)  # the exit codes of a certificate: certified, refuted, undecided
NO_VERDICT = -1  # a limit has ended the process
FAILED = 2


def arguments():
    parser = argparse.ArgumentParser(usage=__doc__.partition("usage: ")[2].partition("\n\n")[0])
    parser.add_argument("--program", default="voroproof")
    parser.add_argument("--shards", type=int)
    parser.add_argument("--report", required=True)
    parser.add_argument("scene")
    parser.add_argument("history")
    return parser.parse_known_args()


class Shard:
    """A process that certifies a shard."""

    def __init__(self, number, of, command):
        """It does not outlive this one."""
        libc = ctypes.CDLL(None)
        set_parent_death_signal = 1
        self.number, self.verdict = number, f"s SHARD {number}/{of} "
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True,
                                        preexec_fn=lambda: libc.prctl(set_parent_death_signal, signal.SIGTERM))

    def is_over(self):
        return self.process.poll() is not None

    def code(self):
        """Its exit code once it is over, if that is a verdict on the shard; else one that is none."""
        out = self.process.communicate()[0].splitlines()
        code = self.process.returncode
        if code in VERDICTS and not (out and out[-1].startswith(self.verdict)):
            return NO_VERDICT
        return code


class Certifier:
    """One rank's work on the numbers of shards that it is given."""

    def __init__(self, asked, options, shards):
        self.asked, self.options, self.shards = asked, options, shards
        self.folder = pathlib.Path(asked.report + ".shards")
        self.folder.mkdir(parents=True, exist_ok=True)

    def path(self, number):
        return self.folder / f"{number}-of-{self.shards}.json"

    def start(self, number):
        """Certifies the shard, or does nothing where its certificate is what it would be."""
        return Shard(number, self.shards,
                     [self.asked.program, "certify", self.asked.scene, self.asked.history, "--truth", "recorded",
                      "--quiet", "--part", f"{number}/{self.shards}", "--resume", "--report", str(self.path(number)),
                      *self.options])

    def merge(self, numbers):
        return subprocess.run([self.asked.program, "certify", "--report", self.asked.report, "--merge",
                               *(str(self.path(number)) for number in numbers)], check=False).returncode


class Dealer:
    """Which shards are left. Those behind one that is not certified do not matter."""

    def __init__(self, certifier):
        self.next, self.last = 1, certifier.shards
        self.failed = []

    def deal(self):
        """The number of a shard that nobody was given; 0 if none is left."""
        if self.next > self.last or self.failed:
            return 0
        self.next += 1
        return self.next - 1

    def take(self, number, code):
        """Notes the outcome of a shard."""
        if code not in VERDICTS:
            self.failed.append((number, code))
        elif code != 0:
            self.last = min(self.last, number)


def work(comm, certifier):
    """A rank that is not the dealer: tells what has become of its shard, and asks for the next."""
    done = None
    while True:
        comm.send(done, dest=DEALER, tag=ASK)
        while not comm.iprobe(source=DEALER, tag=DEAL):
            time.sleep(PATIENCE)
        number = comm.recv(source=DEALER, tag=DEAL)
        if number == 0:
            return
        done = number, certifier.start(number).code()


def deal(comm, certifier):
    """The dealer, who certifies between two looks at the others."""
    dealer = Dealer(certifier)
    others, running = comm.Get_size() - 1, None
    while True:
        if running is not None and running.is_over():
            dealer.take(running.number, running.code())
            running = None
        if running is None:
            own = dealer.deal()
            running = certifier.start(own) if own != 0 else None
        status = MPI.Status()
        while others > 0 and comm.iprobe(source=MPI.ANY_SOURCE, tag=ASK, status=status):
            done = comm.recv(source=status.Get_source(), tag=ASK)
            if done is not None:
                dealer.take(*done)
            number = dealer.deal()
            comm.send(number, dest=status.Get_source(), tag=DEAL)
            others -= number == 0
        if running is None and others == 0:
            return dealer
        time.sleep(PATIENCE)


def main():
    comm = MPI.COMM_WORLD
    asked, options = arguments()
    certifier = Certifier(asked, options, asked.shards or comm.Get_size())
    if comm.Get_rank() != DEALER:
        work(comm, certifier)
        return 0
    dealer = deal(comm, certifier)
    failed = [(number, code) for number, code in dealer.failed if number <= dealer.last]
    for number, code in failed:
        print(f"certify_mpi: shard {number} of {certifier.shards}: exit code {code}", file=sys.stderr)
    return FAILED if failed else certifier.merge(range(1, dealer.last + 1))


def main_or_abort():
    """The others would wait for a rank that fails."""
    try:
        return main()
    except Exception:  # whatever it is
        traceback.print_exc()
        sys.stderr.flush()
        MPI.COMM_WORLD.Abort(FAILED)


if __name__ == "__main__":
    sys.exit(main_or_abort())
