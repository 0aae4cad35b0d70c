"""The ground that an endurance run stands on: a folder, a ROS master, and programs as users start
them. What is started here is ended here, by its process number."""

import ctypes
import logging
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import threading
import time
import uuid

import rosgraph
import rospy
from std_srvs.srv import Trigger

from latticeworld import srv
from ledger import promise

C_LIBRARY = ctypes.CDLL(None)
PR_SET_PDEATHSIG, CLONE_NEWNS = 1, 0x20000
DEADLINE_S = 300.0  # for what must happen; far beyond what it takes
MARK = "LATTICEWORLD_ENDURANCE"  # variable by which the processes of a round are known
SERVICES = {
    "generate_world": srv.GenerateWorld, "save_world": srv.SaveWorld, "load_world": srv.LoadWorld,
    "list_worlds": srv.ListWorlds, "get_world": srv.GetWorld, "spawn_agent": srv.SpawnAgent,
    "remove_agent": srv.RemoveAgent, "reset_world": srv.ResetWorld, "step": srv.Step,
    "save_snapshot": srv.SaveSnapshot, "restore_snapshot": srv.RestoreSnapshot,
    "set_real_time_factor": srv.SetRealTimeFactor, "pause": Trigger, "unpause": Trigger,
    "start_episode": srv.StartEpisode, "stop_episode": srv.StopEpisode,
    "list_episodes": srv.ListEpisodes, "get_world_bundle": srv.GetWorldBundle,
    "spawn_element": srv.SpawnElement, "remove_element": srv.RemoveElement,
    "open_gate": srv.OpenGate, "set_policy": srv.SetPolicy, "set_weather": srv.SetWeather,
    "query_terrain": srv.QueryTerrain, "query_things": srv.QueryThings, "lockstep": srv.Lockstep}
SMALL_WORLD = {"layout_instruction": "A lake in the east, forest in the north.",
               "environment_instruction": "Two sheep graze, a wheeled robot waits in the center.",
               "size": 64.0}


def own_mounts():
    """What is mounted from now on only this process and its programs see, and it ends with them."""
    if C_LIBRARY.unshare(CLONE_NEWNS) == 0:
        subprocess.run(["mount", "--make-rprivate", "/"], check=False)


def wait_until(condition, what, deadline_s=DEADLINE_S):
    """Asks again and again; a broken promise where it does not become true in time."""
    end = time.monotonic() + deadline_s
    while not condition():
        promise(time.monotonic() < end, f"not within {deadline_s:.0f} s: {what}")
        threading.Event().wait(0.02)


def marked_processes(mark):
    """Numbers of the processes that live and were started under the mark, children too."""
    wanted = f"{MARK}={mark}".encode()
    found = []
    for folder in pathlib.Path("/proc").iterdir():
        try:
            if folder.name.isdigit() and wanted in (folder / "environ").read_bytes().split(b"\0"):
                if (folder / "stat").read_text().rsplit(")", 1)[1].split()[0] != "Z":
                    found.append(int(folder.name))
        except OSError:  # it has ended meanwhile
            pass
    return found


class Program:
    """A program that runs, with all that it says in a file. A context: it ends with it."""

    def __init__(self, command, log, environment=None, limits=None):
        self.mark = uuid.uuid4().hex
        self.log = log

        def before():
            C_LIBRARY.prctl(PR_SET_PDEATHSIG, signal.SIGKILL)  # it does not outlive the run
            if limits:
                limits()

        with open(log, "ab") as said:
            self.process = subprocess.Popen(
                list(map(str, command)), stdout=said, stderr=subprocess.STDOUT,
                env={**os.environ, **(environment or {}), MARK: self.mark}, preexec_fn=before)
        self.pid = self.process.pid

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop(signal.SIGKILL)
        self.end_all()

    def runs(self):
        return self.process.poll() is None

    def text(self):
        return self.log.read_text(errors="replace")

    def last_words(self):
        lines = [line for line in self.text().splitlines() if line.strip()]
        return " / ".join(lines[-3:])[-400:]

    def stop(self, how=signal.SIGINT):
        """Ends it; its exit status."""
        if self.runs():
            self.process.send_signal(how)
        return self.wait()

    def wait(self, deadline_s=DEADLINE_S):
        try:
            return self.process.wait(deadline_s)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
            promise(False, f"{self.process.args[0]} did not end within {deadline_s:.0f} s: "
                    f"{self.last_words()}")

    def kill(self):
        """SIGKILL; then no process that it started may be left. Whether it was running."""
        ran = self.runs()
        self.stop(signal.SIGKILL)
        try:
            wait_until(lambda: not marked_processes(self.mark), "all its processes have ended")
        finally:
            self.end_all()
        return ran

    def end_all(self):
        for pid in marked_processes(self.mark):
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass


class Ground:
    """Folder, master and programs of a run. A context."""

    last_failure = ""  # of a call without an answer, as rospy tells it

    def __init__(self, folder, programs, libraries):
        self.folder = folder
        self.programs, self.libraries = programs, libraries
        self.wanted = ("",)  # only rounds whose name begins with one of these
        self._count = 0
        self._master = None

    def __enter__(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            self.port = taken.getsockname()[1]
        home = self.folder / "home"
        home.mkdir()
        for name in ("ROS_NAMESPACE", "ROS_HOSTNAME", "ROSCONSOLE_CONFIG_FILE", "PYENV_VERSION"):
            os.environ.pop(name, None)
        os.environ.update(
            PATH="/usr/bin:" + os.environ.get("PATH", ""), ROS_IP="127.0.0.1",
            ROS_MASTER_URI=f"http://127.0.0.1:{self.port}/", HOME=str(home), ROS_HOME=str(home),
            ROS_LOG_DIR=str(home / "log"))
        self.start_master()
        rospy.init_node("endurance", disable_signals=True, disable_rosout=True)
        logging.getLogger("rosout").setLevel(logging.ERROR)  # services that are not there yet
        return self

    def __exit__(self, *_):
        rospy.signal_shutdown("the run is over")
        self.stop_master()

    def start_master(self):
        self._master = Program(["rosmaster", "--core", "-p", self.port], self.folder / "master.log")
        master = rosgraph.Master("/endurance", master_uri=f"http://127.0.0.1:{self.port}/")
        wait_until(master.is_online, "the master is there")

    def stop_master(self):
        self._master.stop(signal.SIGKILL)

    def new_folder(self, name):
        self._count += 1
        folder = self.folder / f"{self._count:04d}-{name}"
        folder.mkdir()
        return folder

    @staticmethod
    def remove(folder):
        shutil.rmtree(folder, ignore_errors=True)

    def log(self, name):
        self._count += 1
        return self.folder / f"{self._count:04d}-{name}.log"

    def node(self, name, environment=None, limits=None, **parameters):
        """Starts a node with these private parameters and no others."""
        if rospy.has_param(f"/{name}"):
            rospy.delete_param(f"/{name}")
        for key, value in parameters.items():
            rospy.set_param(f"/{name}/{key}", value if isinstance(value, (list, int, float)) else
                          str(value))
        return Program([self.programs / name], self.log(name), environment, limits)

    def program(self, *command, environment=None, limits=None):
        return Program(command, self.log(pathlib.Path(command[0]).name), environment, limits)

    def command(self, *arguments, environment=None, limits=None):
        """Starts the command line `latticeworld`."""
        return self.program(self.programs / "latticeworld", *arguments, environment=environment,
                            limits=limits)

    def tool(self, name, *arguments):
        """Runs a program to its end; exit status and all that it says."""
        with Program([self.programs / name, *arguments], self.log(name)) as program:
            return program.wait(), program.text()

    def must_run(self, *arguments):
        status, said = self.tool("latticeworld", *arguments)
        promise(status == 0, f"latticeworld {arguments[0]} ended with {status}: {said[-400:]}")

    def world_server(self, environment=None, limits=None, **parameters):
        """A world_server that answers."""
        server = self.node("world_server", environment, limits, **parameters)
        self.wait_for(server, "generate_world", "save_world", "list_worlds")
        return server

    def recorder(self, directory, environment=None, limits=None):
        recorder = self.node("episode_recorder", environment, limits, directory=directory)
        self.wait_for(recorder, *(n for n in SERVICES if n.endswith(("episode", "episodes"))))
        return recorder

    def wait_for(self, program, *services):
        """Until a node that was started gives these services."""
        for name in services:
            wait_until(lambda: self._is_up(name) or not program.runs(), f"{name} is there")
        promise(program.runs(), f"a node ended at its start: {program.last_words()}")

    @staticmethod
    def _is_up(name):
        try:
            rospy.wait_for_service(name, timeout=0.5)
            return True
        except (rospy.ROSException, rosgraph.MasterException, OSError):
            return False

    @staticmethod
    def call(service, deadline_s=DEADLINE_S, **request):
        """The response of a service; None where the connection ended without one."""
        answer = []

        def ask():
            try:
                answer.append(rospy.ServiceProxy(service, SERVICES[service])(**request))
            except (rospy.ServiceException, rospy.ROSException, OSError) as error:
                Ground.last_failure = str(error)
                answer.append(None)

        thread = threading.Thread(target=ask, daemon=True)
        thread.start()
        thread.join(deadline_s)
        promise(bool(answer), f"{service} did not answer within {deadline_s:.0f} s")
        return answer[0]

    def must(self, service, **request):
        """The response of a service that has to do what it is asked."""
        answer = self.call(service, **request)
        promise(answer is not None, f"{service} {brief(request)}: no answer")
        good = answer.success if hasattr(answer, "success") else answer.status.code == 0
        promise(good, f"{service} {brief(request)}: {told(answer)}")
        return answer


def brief(request):
    return {key: value for key, value in request.items() if key in ("name", "seed")}


def told(answer):
    """What a service's response says, in one line."""
    if answer is None:
        return f"no answer: {Ground.last_failure}"
    if hasattr(answer, "success"):
        return "done" if answer.success else answer.message
    return "done" if answer.status.code == 0 else f"{answer.status.code}: {answer.status.message}"
