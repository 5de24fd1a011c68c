# SPDX-License-Identifier: GPL-2.0-or-later
"""The package as pip installs it: built without any other package, its version the project's."""

import base64
import email
import hashlib
import re
import subprocess
import sys
import unittest
import zipfile

from support import PACKAGE, REPOSITORY, FileTest, rodpack


class Package(FileTest):
    def build(self):
        """Builds the wheel as pip does, with the hook that pyproject.toml names. Returns its path."""
        hook = "import sys, wheel; print(wheel.build_wheel(sys.argv[1]))"
        done = subprocess.run([sys.executable, "-B", "-c", hook, self.folder], cwd=PACKAGE, check=True,
                              stdout=subprocess.PIPE, text=True)
        return self.folder / done.stdout.strip()

    def test_the_wheel_holds_the_modules_and_their_digests(self):
        wheel = self.build()
        self.assertRegex(wheel.name, r"^rodpack-[0-9.]+-py3-none-any\.whl$")
        with zipfile.ZipFile(wheel) as archive:
            files = {name: archive.read(name) for name in archive.namelist()}
        modules = {f"rodpack/{file.name}" for file in (PACKAGE / "rodpack").glob("*.py")}
        self.assertLess({"rodpack/__init__.py", "rodpack/dumps.py"}, modules)
        self.assertEqual({name for name in files if name.startswith("rodpack/")}, modules)
        info = next(name for name in files if name.endswith("/RECORD")).rpartition("/")[0]
        metadata = email.message_from_bytes(files[f"{info}/METADATA"])
        self.assertEqual((metadata["Name"], metadata["Version"]), ("rodpack", rodpack.__version__))
        self.assertEqual(metadata.get_all("Requires-Dist"), ["numpy>=1.23"])
        for line in files[f"{info}/RECORD"].decode().splitlines():
            name, digest, size = line.split(",")
            if digest:
                expected = base64.urlsafe_b64encode(hashlib.sha256(files[name]).digest()).rstrip(b"=")
                self.assertEqual((digest, size), (f"sha256={expected.decode()}", str(len(files[name]))))

    def test_it_works_from_the_wheel(self):
        table = self.write("a.csv", "x\n1\n2\n")
        code = "import sys, rodpack; print(rodpack.__file__, rodpack.read_table(sys.argv[1])['x'].sum())"
        done = subprocess.run([sys.executable, "-B", "-c", code, table], check=True, stdout=subprocess.PIPE,
                              env={"PYTHONPATH": str(self.build())}, text=True)
        self.assertIn(".whl/rodpack/__init__.py 3.0", done.stdout)

    def test_the_version_is_the_projects(self):
        project = re.search(r"project\(rodpack VERSION (\S+)", (REPOSITORY / "CMakeLists.txt").read_text())[1]
        text = (PACKAGE / "pyproject.toml").read_text()
        self.assertEqual(rodpack.__version__, project)
        self.assertEqual(re.search(r'^version = "(.*)"', text, re.M)[1], project)

    def test_it_imports_numpy_and_pythons_own_modules_alone(self):
        for file in (PACKAGE / "rodpack").glob("*.py"):
            for name in re.findall(r"^(?:from|import) (\w+)", file.read_text(), re.M):
                self.assertTrue(name == "numpy" or name in sys.stdlib_module_names, f"{file.name}: {name}")


if __name__ == "__main__":
    unittest.main()
