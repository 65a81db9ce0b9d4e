# SPDX-License-Identifier: MIT
"""A data set by a Slurm job array on two nodes, one of which is killed while it renders: every frame is there once, and the
bytes are those of a single run. Controller, nodes and munge are real; each node has a network and a host name of its own.
Needs root. slurm.log in the folder NICOL_TEST_LOGS has what the daemons and the tasks say."""

import contextlib
import os
import shutil
import subprocess
import sys
import threading
import unittest

try:
    import numpy  # noqa: F401: the data sets need it
except ImportError:
    print("skipped: numpy is absent")
    sys.exit(77)
PROGRAMS = ("slurmctld", "slurmd", "sbatch", "munged", "mungekey", "ip", "unshare")
missing = [name for name in PROGRAMS if shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin") is None]
if missing or os.geteuid() != 0:
    print(f"skipped: {', '.join(missing) or 'root'} is absent")
    sys.exit(77)

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "dataset"))
from data_set import DataSetTest  # noqa: E402

SCRIPT = os.path.join(HERE, "..", "..", "samples", "dataset", "slurm.sh")
BRIDGE = f"n{os.getpid()}"
NODES = ("node1", "node2")
CONFIGURATION = """ClusterName=test
SlurmctldHost=controller(10.77.0.1)
AuthInfo=socket={folder}/munge.socket,cred_expire=5
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/%n
SlurmctldPidFile={folder}/controller.pid
SlurmdPidFile={folder}/%n.pid
ProctrackType=proctrack/pgid
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdTimeout=5
NodeName=node1 NodeAddr=10.77.0.11 CPUs=1 State=UNKNOWN
NodeName=node2 NodeAddr=10.77.0.12 CPUs=1 State=UNKNOWN
PartitionName=all Nodes=node1,node2 Default=YES MaxTime=INFINITE State=UP
"""
# The Python of the jobs. On node2 everything dies, the daemon of the node too, when a frame is written and not renamed.
PYTHON = """#!{python}
import os, runpy, socket, subprocess, sys
from nicol.dataset import folder
real = folder.os.rename
def rename(*arguments):
    if socket.gethostname() == "node2":
        open("{killed}", "w").close()
        pids = subprocess.run(["ip", "netns", "pids", "{bridge}-node2"], capture_output=True, text=True).stdout.split()
        for pid in sorted(map(int, pids), key=lambda pid: pid == os.getpid()):
            os.kill(pid, 9)
    return real(*arguments)
folder.os.rename = rename
sys.argv[:2] = []
runpy.run_module("nicol.dataset", run_name="__main__", alter_sys=True)
"""


class SlurmTest(DataSetTest):
    def command(self, text):
        ended = subprocess.run(text.split(), capture_output=True, text=True, timeout=280, check=False)
        self.assertEqual(ended.returncode, 0, f"{text}: {ended.stdout}{ended.stderr}")

    def daemon(self, text, ready):
        """Starts a daemon in the foreground, and returns when it has said that it is ready."""
        started = subprocess.Popen(text, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        said, heard = [], threading.Event()

        def listen():
            for line in started.stdout:
                self.log(line)
                said.append(line)
                if ready in line:
                    heard.set()
            heard.set()

        listener = threading.Thread(target=listen, daemon=True)
        self.addCleanup(started.stdout.close)
        self.addCleanup(listener.join, 10)
        self.addCleanup(started.wait)
        self.addCleanup(started.kill)
        listener.start()
        heard.wait()
        self.assertIn(ready, "".join(said), f"{text[-1]} has ended")

    def log(self, text):
        with open(self.log_path(), "a") as file:
            file.write(text)

    def log_path(self):
        return os.path.join(os.environ.get("NICOL_TEST_LOGS", self.folder), "slurm.log")

    def start_cluster(self):
        os.mkdir(self.path("state"))
        with open(self.path("slurm.conf"), "w") as file:
            file.write(CONFIGURATION.format(folder=self.folder))
        with open(self.path("cgroup.conf"), "w") as file:
            file.write("CgroupPlugin=cgroup/v1\n")
        os.environ |= {"SLURM_CONF": self.path("slurm.conf"), "PATH": os.environ["PATH"] + ":/usr/sbin"}
        self.command(f"mungekey --create --keyfile {self.path('key')}")
        munge = f"munged --foreground --force --socket {self.path('munge.socket')} --key-file {self.path('key')}"
        munge += f" --pid-file {self.path('munge.pid')} --seed-file {self.path('munge.seed')}"
        self.daemon(munge.split(), "Created socket")
        self.command(f"ip link add {BRIDGE} type bridge")
        self.addCleanup(self.command, f"ip link del {BRIDGE}")
        self.command(f"ip addr add 10.77.0.1/24 dev {BRIDGE}")
        self.command(f"ip link set {BRIDGE} up")
        for number, node in enumerate(NODES):
            self.start_network(node, number)
        self.daemon(["unshare", "-u", "sh", "-c", "hostname controller; exec slurmctld -D"], "Running as primary controller")
        for node in NODES:
            inside = f"hostname {node}; exec slurmd -D"
            self.daemon(["ip", "netns", "exec", f"{BRIDGE}-{node}", "unshare", "-u", "sh", "-c", inside], "slurmd started")

    def start_network(self, node, number):
        space, link = f"{BRIDGE}-{node}", f"{BRIDGE}{number}"
        self.command(f"ip netns add {space}")
        self.addCleanup(self.command, f"ip netns del {space}")
        self.command(f"ip link add {link} type veth peer name eth0 netns {space}")
        self.command(f"ip link set {link} master {BRIDGE} up")
        self.command(f"ip -n {space} addr add 10.77.0.1{number + 1}/24 dev eth0")
        self.command(f"ip -n {space} link set eth0 up")
        self.command(f"ip -n {space} link set lo up")

    def test_a_node_is_killed(self):
        with contextlib.suppress(FileNotFoundError):
            os.remove(self.log_path())
        recipe = self.recipe(size=[64, 48], write=["mosaic", "stokes", "normals"])
        self.render(recipe, "0:12", "once")
        python = self.path("python")
        with open(python, "w") as file:
            file.write(PYTHON.format(python=sys.executable, bridge=BRIDGE, killed=self.path("killed")))
        os.chmod(python, 0o755)
        os.environ["PYTHON"] = python
        self.start_cluster()
        self.command(f"sbatch --wait --array=0-5 --output {self.path('job-%a.txt')} {SCRIPT} {recipe} {self.path('array')} 2")
        self.log(subprocess.run(["scontrol", "show", "job"], capture_output=True, text=True, check=True).stdout)
        for task in range(6):
            with open(self.path(f"job-{task}.txt")) as file:
                self.log(f"task {task}: {file.read()}")
        self.assertTrue(os.path.exists(self.path("killed")))
        self.render(recipe, "0:0", "array")  # removes what the killed task left
        self.assert_same_tree("once", "array")


if __name__ == "__main__":
    unittest.main()
