# SPDX-License-Identifier: BSD-3-Clause
"""The type stubs say what the extension module has, and the package's own code is annotated."""

import ast
import inspect
import os
import re
import unittest

import hogelscope as hs
from hogelscope import _hogelscope, _content, _figures, _measure, _session, _view


def parameters_of(function):
    """Names of the parameters in the signature that pybind11 writes into the docstring."""
    signature = re.search(r"\((.*)\) -> ", function.__doc__.splitlines()[0]).group(1)
    flat, nested = signature, ""
    while flat != nested:  # without what is in brackets
        flat, nested = re.sub(r"\[[^\[\]]*\]|\([^()]*\)", "", flat), flat
    return [part.split(":")[0].split("=")[0].strip() for part in flat.split(",") if part.strip()]


def parameters_in(stub):
    found = [argument.arg for argument in stub.args.args]
    return found + (["*"] if stub.args.kwonlyargs else []) + [a.arg for a in stub.args.kwonlyargs]


class Stubs(unittest.TestCase):
    def setUp(self):
        with open(os.path.join(os.path.dirname(hs.__file__), "_hogelscope.pyi"),
                  encoding="utf-8") as file:
            self.stub = ast.parse(file.read())

    def compare(self, module, body):
        """Functions and classes of a module or a class."""
        stubs = {node.name: node for node in body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
        values = {node.target.id for node in body if isinstance(node, ast.AnnAssign)}
        real = {name for name, member in vars(module).items() if not name.startswith("_")
                or (name == "__init__" and "->" in (member.__doc__ or ""))}  # may be constructed
        self.assertEqual(set(stubs) | values, real - {"doc"})
        for name, node in stubs.items():
            member = vars(module)[name]
            if isinstance(node, ast.ClassDef):
                if not issubclass(member, BaseException):
                    self.compare(member, node.body)
            elif not isinstance(member, property):
                function = getattr(module, name)
                self.assertEqual(parameters_in(node), parameters_of(function), name)
                self.assertIsNotNone(node.returns, name)

    def test_stub_is_fresh(self):
        self.compare(_hogelscope, self.stub.body)

    def test_all_is_annotated(self):
        for module in (_content, _figures, _measure, _session, _view):
            for name, value in vars(module).items():
                functions = [value] if inspect.isfunction(value) else []
                if inspect.isclass(value) and value.__module__ == module.__name__:
                    functions = [f for f in vars(value).values() if inspect.isfunction(f)]
                for function in functions:
                    if function.__module__ != module.__name__:
                        continue
                    signature = inspect.signature(function)
                    self.assertIsNot(signature.return_annotation, inspect.Signature.empty, name)
                    for parameter in signature.parameters.values():
                        if parameter.name not in ("self", "cls"):
                            self.assertIsNot(parameter.annotation, inspect.Parameter.empty,
                                             f"{name}: {parameter.name}")


if __name__ == "__main__":
    unittest.main()
