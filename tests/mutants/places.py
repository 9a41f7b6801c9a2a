"""Places of a Rust file that can be switched between the original and a change.

In: a file's text and what cargo-mutants lists for it. Out: byte ranges with a function that writes the switch. Every
switch keeps the lines of the file, so that the compiler's messages name the mutant that they are about.
"""

import tree_sitter
import tree_sitter_rust

RUST = tree_sitter.Parser(tree_sitter.Language(tree_sitter_rust.language()))
# Calls that mean an operation on expressions, vectors or sequences, and what is called instead.
CALLS = {
    "add": "sub", "sub": "add", "mul": "add", "plus": "minus", "minus": "plus", "min": "max", "max": "min",
    "all": "any", "any": "all", "sin": "cos", "cos": "sin",
}
# Calls for their effect alone, which may be left out.
EFFECTS = {"push", "insert", "extend", "add_force", "add_mass", "retain", "sort", "clear", "fill"}


def of(name, text, offered):
    """All places of a file outside its own tests."""
    root = RUST.parse(text).root_node
    lines = [0]
    for line in text.split(b"\n"):
        lines.append(lines[-1] + len(line) + 1)
    at = lambda place: lines[place["line"] - 1] + len(
        text[lines[place["line"] - 1] : lines[place["line"]]].decode()[: place["column"] - 1].encode()
    )
    found = []

    def place(start, end, what, switch):
        first, last = text.count(b"\n", 0, start) + 1, text.count(b"\n", 0, end) + 1
        line = text[lines[first - 1] : lines[first] - 1].decode().strip()
        found.append({
            "file": name, "start": start, "end": end, "lines": (first, last), "switch": switch,
            "key": f"{name} | {line} | {what}",
        })

    for mutant in offered:
        start, end, by = at(mutant["span"]["start"]), at(mutant["span"]["end"]), mutant["replacement"].encode()
        node = root.descendant_for_byte_range(start, end)
        what = mutant["name"].split(": ", 1)[1].split(" in ")[0]
        if mutant["genre"] == "BinaryOperator":
            whole = node if node.type == "binary_expression" else node.parent
            if whole and whole.type == "binary_expression" and not inside_pattern(whole):
                place(whole.start_byte, whole.end_byte, what, operator(whole, text, by))
        elif mutant["genre"] == "UnaryOperator":
            whole = node if node.type == "unary_expression" else node.parent
            if whole and whole.type == "unary_expression" and not inside_pattern(whole):
                inner = text[whole.start_byte + 1 : whole.end_byte]
                place(whole.start_byte, whole.end_byte, what, lambda test, old, new=inner: either(test, new, old))
        elif mutant["genre"] == "FnValue":
            value = b"" if by == b"()" else by
            back = lambda test, old, value=value: b"if %s { return %s; } %s" % (test, value, old)
            # An empty range before the body: other places may lie in it.
            place(start, start, what, back)
    walk(root, text, place)
    return found


def either(test, changed, original):
    return b"(if %s { %s } else { %s })" % (test, changed.replace(b"\n", b" "), original)


def operator(node, text, by):
    sign = node.children[1]
    before = text[node.start_byte : sign.start_byte]
    after = text[sign.end_byte : node.end_byte]
    return lambda test, old: either(test, before + by + after, old)


def inside_pattern(node):
    """Constants are no place for a switch, nor are the tests of a file."""
    while node:
        if node.type in ("const_item", "static_item", "attribute_item", "mod_item", "array_type", "macro_invocation"):
            return True
        node = node.parent
    return False


def walk(node, text, place):
    """Calls from the syntax tree."""
    if node.type in ("const_item", "static_item", "mod_item", "macro_invocation"):
        return
    if node.type == "call_expression" and node.children[0].type == "field_expression":
        method = node.children[0].child_by_field_name("field")
        called = text[method.start_byte : method.end_byte].decode()
        statement = node.parent is not None and node.parent.type == "expression_statement"
        if called in CALLS:
            new = CALLS[called].encode()
            before, after = text[node.start_byte : method.start_byte], text[method.end_byte : node.end_byte]
            switch = lambda test, old: either(test, before + new + after, old)
            place(node.start_byte, node.end_byte, f"{called} -> {CALLS[called]}", switch)
        elif called in EFFECTS and statement:
            place(node.start_byte, node.end_byte, f"no {called}", lambda test, old: b"if !%s { %s }" % (test, old))
    for child in node.children:
        walk(child, text, place)
