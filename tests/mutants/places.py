"""Places of a Rust file that can be switched between the original and a change, from its syntax tree.

In: a file's text. Out: byte ranges with a function that writes the switch. Every switch keeps the lines of the file,
so that the compiler's messages name the mutant that they are about.
"""

import tree_sitter
import tree_sitter_rust

RUST = tree_sitter.Parser(tree_sitter.Language(tree_sitter_rust.language()))
# What stands in place of an operator.
OPERATORS = {
    "+": "-", "-": "+", "*": "/", "/": "*", "%": "+", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==",
    "&&": "||", "||": "&&", "&": "|", "|": "&", "^": "&", "<<": ">>", ">>": "<<",
}
# Calls that mean an operation on expressions, vectors or sequences, and what is called instead.
CALLS = {
    "add": "sub", "sub": "add", "mul": "add", "plus": "minus", "minus": "plus", "min": "max", "max": "min",
    "all": "any", "any": "all", "sin": "cos", "cos": "sin",
}
# Calls for their effect alone, which may be left out.
EFFECTS = {"push", "insert", "extend", "add_force", "add_mass", "retain", "sort", "clear", "fill"}
# What a function of this type returns at once.
VALUES = {"bool": ("true", "false"), "usize": ("0", "1"), "()": ("",)}
# Constants are no place for a switch, nor are the tests of a file.
CLOSED = {"const_item", "static_item", "attribute_item", "mod_item", "array_type", "macro_invocation", "match_pattern"}


def of(name, text):
    """All places of a file outside its own tests."""
    found = []

    def place(start, end, what, switch):
        first, last = text.count(b"\n", 0, start) + 1, text.count(b"\n", 0, end) + 1
        line = text[text.rfind(b"\n", 0, start) + 1 : text.find(b"\n", start)].decode().strip()
        found.append({
            "file": name, "start": start, "end": end, "lines": (first, last), "switch": switch,
            "key": f"{name} | {line} | {what}",
        })

    walk(RUST.parse(text).root_node, text, place)
    return found


def either(test, changed, original):
    return b"(if %s { %s } else { %s })" % (test, changed.replace(b"\n", b" "), original)


def walk(node, text, place):
    """Operators, signs, calls and whole functions below a node."""
    if node.type in CLOSED or is_constant(node):
        return
    {"binary_expression": operator, "compound_assignment_expr": assignment, "unary_expression": sign,
     "call_expression": call, "function_item": function}.get(node.type, lambda *_: None)(node, text, place)
    for child in node.children:
        walk(child, text, place)


def is_constant(node):
    """A `const fn` is evaluated by the compiler, which knows no mutant."""
    return node.type == "function_item" and any(
        c.type == "function_modifiers" and b"const" in c.text for c in node.children
    )


def operator(node, text, place):
    sign = node.child_by_field_name("operator")
    new = OPERATORS.get(sign.text.decode())
    # A condition that binds names is no value.
    if not new or b"let " in node.text and sign.text in (b"&&", b"||"):
        return
    before, after = text[node.start_byte : sign.start_byte], text[sign.end_byte : node.end_byte]
    switch = lambda test, old: either(test, before + new.encode() + after, old)
    place(node.start_byte, node.end_byte, f"{sign.text.decode()} -> {new}", switch)


def assignment(node, text, place):
    sign = node.child_by_field_name("operator")
    new = OPERATORS.get(sign.text.decode().removesuffix("="))
    if new:
        before, after = text[node.start_byte : sign.start_byte], text[sign.end_byte : node.end_byte]
        changed = before + new.encode() + b"=" + after
        place(node.start_byte, node.end_byte, f"{sign.text.decode()} -> {new}=",
              lambda test, old: b"if %s { %s } else { %s }" % (test, changed.replace(b"\n", b" "), old))


def sign(node, text, place):
    if node.children[0].type in ("-", "!"):
        inner = text[node.start_byte + 1 : node.end_byte]
        place(node.start_byte, node.end_byte, f"no {node.children[0].type}", lambda test, old: either(test, inner, old))


def call(node, text, place):
    if node.children[0].type != "field_expression":
        return
    method = node.children[0].child_by_field_name("field")
    called = method.text.decode()
    statement = node.parent is not None and node.parent.type == "expression_statement"
    if called in CALLS:
        before, after = text[node.start_byte : method.start_byte], text[method.end_byte : node.end_byte]
        switch = lambda test, old: either(test, before + CALLS[called].encode() + after, old)
        place(node.start_byte, node.end_byte, f"{called} -> {CALLS[called]}", switch)
    elif called in EFFECTS and statement:
        place(node.start_byte, node.end_byte, f"no {called}", lambda test, old: b"if !%s { %s; }" % (test, old))


def function(node, text, place):
    """The body's value at once; an empty range behind its brace, in which no other place lies."""
    body, kind = node.child_by_field_name("body"), node.child_by_field_name("return_type")
    kind = kind.text.decode() if kind else "()"
    values = ("None",) if kind.startswith("Option<") else VALUES.get(kind, ())
    for value in values if body else ():
        at = body.start_byte + 1
        back = lambda test, old, value=value: b" if %s { return %s; }" % (test, value.encode())
        place(at, at, f"fn {node.child_by_field_name('name').text.decode()} returns {value or 'at once'}", back)
