#!/usr/bin/python3
"""Runs one rostest in a world of its own: a ROS master on a free port (rostest starts it), a home
and a log folder that are removed afterwards, the built devel space, and Debian's python first.

Usage: run_rostest.py ENV_SCRIPT TEST_FILE
"""

import os
import signal
import subprocess
import sys
import tempfile


def main():
    env_script, test_file = sys.argv[1:]
    with tempfile.TemporaryDirectory(prefix="latticeworld_rostest_") as home:
        env = dict(os.environ)
        # What another workspace or a running robot has set must not reach the test.
        for name in [name for name in env if name.startswith(("ROS_", "ROSLISP_"))]:
            del env[name]
        for name in ("CMAKE_PREFIX_PATH", "PYTHONPATH", "LD_LIBRARY_PATH", "PYENV_VERSION"):
            env.pop(name, None)
        env.update(PATH="/usr/bin:" + env.get("PATH", ""), HOME=home, ROS_HOME=home,
                   ROS_LOG_DIR=os.path.join(home, "log"), ROS_IP="127.0.0.1",
                   ROS_TEST_RESULTS_DIR=os.path.join(home, "results"),
                   PYTHONDONTWRITEBYTECODE="1")
        # In a session of its own, so that whatever ends this script ends every node with it.
        test = subprocess.Popen([env_script, "rostest", test_file], env=env, start_new_session=True)

        def stop(number, _):
            test.send_signal(signal.SIGINT)
            test.wait(timeout=30)
            sys.exit(128 + number)

        signal.signal(signal.SIGTERM, stop)
        signal.signal(signal.SIGINT, stop)
        code = test.wait()
        if code != 0:
            print_results(os.path.join(home, "results"))
        return code


def print_results(folder):
    """The failures as the test nodes reported them."""
    for root, _, names in os.walk(folder):
        for name in sorted(names):
            if name.endswith(".xml"):
                with open(os.path.join(root, name), encoding="utf-8") as file:
                    print(file.read())


if __name__ == "__main__":
    sys.exit(main())
