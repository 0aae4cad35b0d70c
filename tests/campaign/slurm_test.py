#!/usr/bin/env python3
"""Hands a campaign's job file to a real Slurm: a cluster of one node in a folder of its own, on
loopback, made and ended by the test."""

import getpass
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

CAMPAIGN = """name: tiny
worlds:
  - {name: meadow, layout: Grassland with a few trees., seeds: [1, 2], size_m: 64, resolution_m: 1}
robots: [{stack: way}]
tasks: {count: 2, length_m: [10, 30]}
"""
NEEDED = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "sinfo")
LONGEST_S = 180.0
PATH = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"

CONFIGURATION = """ClusterName=campaign
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
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
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SchedulerType=sched/builtin
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
NodeName={host} NodeAddr=127.0.0.1 CPUs={cores} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Cluster:
    """munged, slurmctld and slurmd in the foreground, so that each is ended by its own id."""

    def __init__(self, folder):
        self.folder, self.processes = folder, []
        folder.chmod(0o700)
        for name in ("state", "spool"):
            (folder / name).mkdir()
        key = folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        self.configuration = folder / "slurm.conf"
        self.configuration.write_text(CONFIGURATION.format(
            host=socket.gethostname().split(".")[0], ports=free_ports(2), folder=folder,
            user=getpass.getuser(), cores=os.cpu_count()))
        self.environment = {**os.environ, "PATH": PATH, "SLURM_CONF": str(self.configuration)}
        self.start("munged", "--foreground", "--force", f"--key-file={key}",
                   f"--socket={folder}/munge.socket", f"--pid-file={folder}/munged.pid",
                   f"--log-file={folder}/munged.log", f"--seed-file={folder}/munge.seed")
        self.wait("munged", (folder / "munge.socket").exists)
        self.start("slurmctld", "-D", "-f", str(self.configuration))
        self.start("slurmd", "-D", "-f", str(self.configuration))
        self.wait("an idle node", lambda: "idle" in self.tell("sinfo", "-h", "-o", "%T"))

    def start(self, *command):
        with open(self.folder / f"{command[0]}.out", "wb") as out:
            self.processes.append(subprocess.Popen(
                [shutil.which(command[0], path=PATH), *command[1:]], stdout=out, stderr=out,
                env=self.environment))

    def tell(self, *command):
        run = subprocess.run(command, capture_output=True, text=True, check=False,
                             env=self.environment, cwd=self.folder)
        return run.stdout if run.returncode == 0 else ""

    def wait_for_jobs(self):
        """Until none is left. squeue says its heading where the controller has answered."""
        self.wait("end of the jobs", lambda: self.tell("squeue", "-o", "%i").split() == ["JOBID"])

    def wait(self, what, is_there):
        end = time.monotonic() + LONGEST_S
        while not is_there():
            for process in self.processes:
                if process.poll() is not None:
                    raise RuntimeError(f"{process.args[0]} ended: {self.logs()}")
            if time.monotonic() > end:
                raise RuntimeError(f"no {what} within {LONGEST_S} s: {self.logs()}")
            time.sleep(0.1)

    def logs(self):
        return "\n".join(f"{path.name}: {path.read_text(errors='replace')[-1500:]}"
                         for pattern in ("*.log", "*.out") for path in self.folder.glob(pattern))

    def end(self):
        for process in reversed(self.processes):
            process.send_signal(signal.SIGTERM)
            try:
                process.wait(timeout=20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


class SlurmTest(unittest.TestCase):
    def setUp(self):
        missing = [name for name in NEEDED if shutil.which(name, path=PATH) is None]
        self.assertEqual(missing, [], "scripts/install_dependencies.sh cluster installs them")
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        (self.folder / "cluster").mkdir()
        self.cluster = None

    def tearDown(self):
        if self.cluster:
            self.cluster.end()
        self.temporary.cleanup()

    def test_the_array_and_its_merge_end_as_one_run(self):
        file = self.folder / "tiny.yaml"
        file.write_text(CAMPAIGN)
        plain, out, job = (self.folder / name for name in ("plain", "out", "job.sbatch"))
        command = [PROGRAM, "campaign", str(file), "--workers", "1", "--out"]
        subprocess.run([*command, str(plain)], check=True, capture_output=True)
        subprocess.run([*command, str(out), "--slurm", str(job), "--shards", "2"], check=True,
                       capture_output=True)
        self.cluster = Cluster(self.folder / "cluster")
        submitted = self.cluster.tell("sbatch", "--parsable", str(job))
        self.assertTrue(submitted.strip(), self.cluster.logs())
        self.cluster.wait_for_jobs()
        said = "\n".join(path.read_text() for path in (self.folder / "cluster").glob("slurm-*"))
        self.assertTrue((out / "report.html").exists(), said)
        for name in ("trials.csv", "summary.json"):
            self.assertEqual((plain / name).read_bytes(), (out / name).read_bytes(), said)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
