"""Slurm runs a campaign's array job on a cluster of one node, with tasks that are put back into the
queue, a limit of time and a node that fails; each ends with the bytes of a plain run."""
# debian: slurmctld slurmd munge slurm-client

import importlib.util
import pathlib

from peer import FOLDER, PROGRAM, Peer, run

TEST = pathlib.Path(__file__).resolve().parents[1] / "tests/campaign/slurm_test.py"
CAMPAIGN = """name: tiny
worlds:
  - {name: meadow, layout: Grassland with a few trees., seeds: [1, 2], size_m: 64, resolution_m: 1}
robots: [{stack: way}]
tasks: {count: 2, length_m: [10, 30]}
"""
SHARDS = "2"
FILES = ("trials.csv", "summary.json")


def cluster_test():
    """tests/campaign/slurm_test.py, whose Cluster it is."""
    spec = importlib.util.spec_from_file_location("slurm_test", TEST)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Campaign:
    """A campaign's job that was handed in."""

    def __init__(self, cluster, name, slow_s=0, options=()):
        self.cluster, self.out = cluster, FOLDER / name
        job = FOLDER / f"{name}.sbatch"
        run(PROGRAM, "campaign", FOLDER / "tiny.yaml", "--out", self.out, "--workers", "1",
            "--slurm", job, "--shards", SHARDS)
        text = job.read_text()
        # A task waits before its shard in its first run, so that something can happen to it.
        wait = f'[ "${{SLURM_RESTART_COUNT:-0}}" -gt 0 ] || sleep {slow_s}\nshard "$SLURM_ARRAY_TASK_ID"'
        job.write_text(text.replace('shard "$SLURM_ARRAY_TASK_ID"', wait))
        self.id = cluster.tell("sbatch", "--parsable", *options, str(job)).strip()

    def states(self):
        return self.cluster.tell("squeue", "-h", "-r", "-j", self.id, "-o", "%T").split()

    def wait_until_running(self):
        self.cluster.wait("running tasks", lambda: "RUNNING" in self.states())

    def restarts(self):
        said = self.cluster.tell("scontrol", "show", "job", self.id)
        return [line.split("Restarts=")[1].split()[0] for line in said.splitlines()
                if "Restarts=" in line]

    def compared(self, plain):
        """(whether the files are those of a plain run, that or what the jobs said)."""
        same = all((self.out / name).exists() and
                   (self.out / name).read_bytes() == (plain / name).read_bytes() for name in FILES)
        said = " / ".join(path.read_text()[-200:] for path in
                          sorted(self.cluster.folder.glob("slurm-*"))[-4:])
        return same, "the bytes of the plain run" if same else f"other files: {said}"


def check_requeue(peer, cluster, plain):
    campaign = Campaign(cluster, "requeued", slow_s=600)
    campaign.wait_until_running()
    cluster.tell("scontrol", "requeue", campaign.id)
    # What was put back begins after two minutes unless its time is taken away.
    cluster.wait("tasks in the queue", lambda: set(campaign.states()) == {"PENDING"})
    for task in range(int(SHARDS)):
        cluster.tell("scontrol", "update", f"JobId={campaign.id}_{task}", "StartTime=now")
    cluster.wait_for_jobs()
    same, words = campaign.compared(plain)
    peer.check("requeue while it runs", same, f"restarts {campaign.restarts()}, {words}")


def check_time_limit(peer, cluster, plain):
    campaign = Campaign(cluster, "limited", slow_s=600, options=("--time=00:00:01",))
    cluster.wait_for_jobs()
    cut = not (campaign.out / "trials").exists() or not list((campaign.out / "trials").iterdir())
    said = "".join(path.read_text() for path in cluster.folder.glob(f"slurm-{campaign.id}_*"))
    merged = "".join(path.read_text() for path in cluster.folder.glob("slurm-*")
                     if not path.name.startswith(f"slurm-{campaign.id}"))
    refusal = next((line for line in reversed(merged.splitlines()) if "campaign" in line), "")
    peer.check("time limit", cut and "TIME LIMIT" in said and not (campaign.out / "report.html").exists(),
               f"cut off; the merge then says: {refusal.replace(str(FOLDER), '...')[:160]}")
    again = Campaign(cluster, "limited")
    cluster.wait_for_jobs()
    peer.check("handed in again", *again.compared(plain))


def check_node_failure(peer, cluster, plain):
    campaign = Campaign(cluster, "failed", slow_s=600)
    campaign.wait_until_running()
    node = cluster.tell("sinfo", "-h", "-o", "%n").strip()
    cluster.tell("scontrol", "update", f"NodeName={node}", "State=DOWN", "Reason=test")
    cluster.wait("tasks in the queue", lambda: set(campaign.states()) == {"PENDING"})
    cluster.tell("scontrol", "update", f"NodeName={node}", "State=RESUME")
    for task in range(int(SHARDS)):
        cluster.tell("scontrol", "update", f"JobId={campaign.id}_{task}", "StartTime=now")
    cluster.wait_for_jobs()
    same, words = campaign.compared(plain)
    peer.check("node that fails", same, f"restarts {campaign.restarts()}, {words}")


def main():
    version = run("dpkg-query", "-W", "-f", "${Version}", "slurmctld").stdout.split("-")[0]
    peer = Peer("Slurm", version, "`campaign --slurm`, 2 shards on one node",
                "after a time limit hand the job in again: what has a result is not run again")
    (FOLDER / "tiny.yaml").write_text(CAMPAIGN)
    plain = FOLDER / "plain"
    run(PROGRAM, "campaign", FOLDER / "tiny.yaml", "--workers", "1", "--out", plain)
    (FOLDER / "cluster").mkdir()
    cluster = cluster_test().Cluster(FOLDER / "cluster")
    try:
        campaign = Campaign(cluster, "array")
        cluster.wait_for_jobs()
        peer.check("array and merge", *campaign.compared(plain))
        check_requeue(peer, cluster, plain)
        check_time_limit(peer, cluster, plain)
        check_node_failure(peer, cluster, plain)
    except RuntimeError as error:
        peer.check("cluster", False, str(error)[-600:])
    finally:
        cluster.end()
    peer.finish()


main()
