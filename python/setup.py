"""Builds the package: the messages of the stream are made from proto/ by protoc, wherever they are needed."""
import os
import shutil
import subprocess
import sys

from setuptools import setup
from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist

HERE = os.path.dirname(os.path.abspath(__file__))
FILES = ("stream", "planar", "surface")


def messages():
    """The folder with filum/stream.proto: of a source distribution, else of the repository."""
    for folder in (os.path.join(HERE, "proto"), os.path.join(HERE, "..", "proto")):
        if os.path.exists(os.path.join(folder, "filum", "stream.proto")):
            return folder
    sys.exit("filum: cannot build: proto/filum/stream.proto is not there; install from a whole checkout")


class WithMessages(build_py):
    def run(self):
        super().run()
        protoc = shutil.which("protoc")
        if protoc is None:
            sys.exit("filum: cannot build: no protoc; install the package protobuf-compiler")
        names = [f"filum/{name}.proto" for name in FILES]
        subprocess.run([protoc, f"--python_out={self.build_lib}", f"-I{messages()}"] + names, check=True)


class WithProto(sdist):
    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        shutil.copytree(os.path.join(messages(), "filum"), os.path.join(base_dir, "proto", "filum"), dirs_exist_ok=True)


setup(cmdclass={"build_py": WithMessages, "sdist": WithProto})
