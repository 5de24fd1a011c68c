# SPDX-License-Identifier: GPL-2.0-or-later
"""Builds the package for pip (PEP 517) without any other package: a wheel is a zip file."""

import base64
import hashlib
import re
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent


def _project(key):
    """A text or a list of one text of pyproject.toml; Python 3.11 is the first that reads TOML by itself."""
    return re.search(rf'^{key} = \[?"([^"]*)"', (HERE / "pyproject.toml").read_text(), re.MULTILINE)[1]


def _name():
    return f"{_project('name')}-{_project('version')}"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Writes the wheel into a folder. Returns its name."""
    info = f"{_name()}.dist-info"
    metadata = (f"Metadata-Version: 2.1\nName: {_project('name')}\nVersion: {_project('version')}\n"
                f"Summary: {_project('description')}\nRequires-Python: {_project('requires-python')}\n"
                f"License: GPL-2.0-or-later\nRequires-Dist: {_project('dependencies')}\n")
    files = {str(file.relative_to(HERE)): file.read_bytes() for file in sorted(HERE.glob("rodpack/*.py"))}
    files[f"{info}/METADATA"] = metadata.encode()
    files[f"{info}/WHEEL"] = (b"Wheel-Version: 1.0\nGenerator: rodpack\nRoot-Is-Purelib: true\n"
                              b"Tag: py3-none-any\n")
    record = ""
    for name, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(content)}\n"
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    wheel = f"{_name()}-py3-none-any.whl"
    with zipfile.ZipFile(Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return wheel
