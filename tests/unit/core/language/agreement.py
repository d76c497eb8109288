"""Runs a batch of programs of the function language in CPython, for agreement_test.cpp.

Reads a JSON list of program texts, prints a JSON list of {"value": repr of res.out, "fault"?: kind}. What the
language decides otherwise than Python is put around Python here: 64-bit integers, assignment that copies, lists where
Python has tuples, views and iterators, d.key, str keys, and no NaN or infinity in a result.
"""
import ast
import copy
import json
import math
import sys

VIEWS = (tuple, type({}.items()), type({}.keys()), type({}.values()))
LIMIT = 2 ** 63
LENGTH = 20_000  # of texts and lists; more is `budget`, as are more turns of loops
TURNS = 20_000


def lists(v):
    if isinstance(v, VIEWS):
        v = list(v)
    if isinstance(v, list):
        return [lists(x) for x in v]
    return v


def computed(v):
    v = lists(v) if isinstance(v, VIEWS) else v
    if type(v) is int and not -LIMIT <= v < LIMIT:
        raise OverflowError
    if isinstance(v, complex):
        raise ValueError
    if isinstance(v, (str, list)) and len(v) > LENGTH:
        raise MemoryError
    return v


def stored(v):
    if isinstance(v, (list, tuple)):
        return type(v)(stored(x) for x in v)
    return {k: stored(x) for k, x in v.items()} if isinstance(v, dict) else v


def keyed(d):
    if not all(isinstance(k, str) for k in d):
        raise TypeError
    return d


def no_text(v):
    if isinstance(v, str):
        raise TypeError
    return v


def attribute(v, name):
    if isinstance(v, dict):
        return v[name]
    raise AttributeError


def finite(v):
    if isinstance(v, float) and not math.isfinite(v):
        raise ValueError
    for x in v if isinstance(v, list) else v.values() if isinstance(v, dict) else ():
        finite(x)
    return v


class Adapt(ast.NodeTransformer):
    @staticmethod
    def call(name, *args):
        return ast.Call(ast.Name(name, ast.Load()), list(args), [])

    def wrapped(self, node):
        self.generic_visit(node)
        return self.call("computed", node)

    visit_UnaryOp = wrapped

    def visit_BinOp(self, node):
        self.generic_visit(node)
        if isinstance(node.op, ast.Mod):
            node.left = self.call("no_text", node.left)
        return self.call("computed", node)

    def visit_Call(self, node):
        method = isinstance(node.func, ast.Attribute)
        if method:
            node.func.value = self.visit(node.func.value)
        node.args = [self.call("stored", self.visit(a)) if method else self.visit(a) for a in node.args]
        for keyword in node.keywords:
            keyword.value = self.visit(keyword.value)
        return self.call("computed", node)

    def visit_Attribute(self, node):
        self.generic_visit(node)
        if isinstance(node.ctx, ast.Load) and not (isinstance(node.value, ast.Name) and node.value.id in ("res", "math")):
            return self.call("attribute", node.value, ast.Constant(node.attr))
        return node

    def visit_Dict(self, node):
        self.generic_visit(node)
        return self.call("keyed", node)

    def visit_Assign(self, node):
        self.generic_visit(node)
        node.value = self.call("stored", node.value)
        return node

    def visit_AugAssign(self, node):
        self.generic_visit(node)
        node.value = self.call("stored", node.value)
        target = copy.deepcopy(node.target)
        target.ctx = ast.Load()
        return [node, ast.Expr(self.call("computed", target))]

    def visit_For(self, node):
        self.visit_While(node)
        node.iter = self.call("stored", node.iter)
        return node

    def visit_While(self, node):
        self.generic_visit(node)
        node.body.insert(0, ast.Expr(self.call("turn")))
        return node


FAULTS = [
    ((KeyError, IndexError), "missing"),
    (ZeroDivisionError, "zero_division"),
    (OverflowError, "overflow"),
    (NameError, "name"),
    (ValueError, "value"),
    ((TypeError, AttributeError), "type"),
    (MemoryError, "budget"),
]


class Results:
    def __setattr__(self, name, value):
        self.__dict__[name] = finite(value)


def run(text):
    tree = ast.fix_missing_locations(Adapt().visit(ast.parse("def f():\n" + "".join(
        "    " + line + "\n" for line in text.split("\n")) + "f()\n")))
    res = Results()
    turns = iter(range(TURNS))

    def turn():
        if next(turns, None) is None:
            raise MemoryError

    names = {
        "res": res, "turn": turn, "math": math, "computed": computed, "stored": stored, "keyed": keyed,
        "no_text": no_text, "attribute": attribute,
        "enumerate": lambda *a, **k: [list(p) for p in enumerate(*a, **k)],
        "zip": lambda *a: [list(p) for p in zip(*a, strict=False)],
        "range": lambda *a: list(range(*a)),
        "reversed": lambda a: list(reversed(a)),
    }
    try:
        exec(compile(tree, "program", "exec"), names)
        return {"value": repr(res.out)}
    except Exception as e:  # every fault of a program is an answer
        for types, kind in FAULTS:
            if isinstance(e, types):
                return {"fault": kind, "value": repr(getattr(res, "out", None))}
        return {"fault": repr(e)}


json.dump([run(text) for text in json.load(sys.stdin)], sys.stdout)
