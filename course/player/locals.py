# Run inside gdb: the lines that a traced submission reaches, and its local
# variables there. Beside each stands how many uses of the table the recorder
# has counted so far, and the stack's pointer to the call, so that both records
# fit together exactly.
#
# Environment: COURSE_FILE the source as it was compiled, COURSE_LOCALS the file
# to write, COURSE_MOST how many lines of a walk are kept. Of each walk a line
# "walk", then lines of fields with tabs between: count, line, address, stack,
# function, and for each variable that has a value its name and that as JSON; of
# one that had one at the stop before, its last value and a - before its name.
# Line 0 is none: a function begins, or ends without a return. Line -1: there are
# more, which are not kept.
import json
import os
import re
import struct
from functools import partial

import gdb

MOST_ELEMENTS = 40
MOST_LINES = 20  # of a declaration
# What g++ gives to variables without a value, and clang: the last one to real
# numbers. Of a single byte it may be a value as well.
PATTERNS = (0xFE, 0xAA, 0xFF)


class Hidden(Exception):
    """There is nothing to show of this value."""


class NoValue(Hidden):
    """It has none yet."""


# ---- values


def integer(value):
    if value.type.sizeof > 1 and is_pattern(value, PATTERNS[:2]):
        raise NoValue
    return int(value)


def real(value):
    if is_pattern(value, PATTERNS):
        raise NoValue
    return float(value)


def boolean(value):
    if int(value) > 1:
        raise Hidden
    return int(value) != 0


def bytes_of(value):
    """Of a value; none when it stands nowhere, as a reference to nothing."""
    try:
        return bytes(gdb.selected_inferior().read_memory(int(value.address),
                                                         value.type.sizeof))
    except (TypeError, gdb.error):
        return b""


def is_pattern(value, patterns):
    raw = bytes_of(value)
    return raw != b"" and any(raw == bytes([byte]) * len(raw) for byte in patterns)


def enumerator(value):
    return str(value).split("::")[-1]


def elements(first, count):
    if not 0 <= count < 1 << 24:
        raise Hidden
    if count > MOST_ELEMENTS:
        return f"{count} elements"
    target = first.type.strip_typedefs().target().strip_typedefs()
    if target.code == gdb.TYPE_CODE_INT and target.sizeof == 4 and count > 0:
        raw = gdb.selected_inferior().read_memory(int(first), 4 * count)
        return list(struct.unpack(f"{count}i", raw))
    return [shown((first + k).dereference()) for k in range(count)]


def vector(value):
    first = value["_M_impl"]["_M_start"]
    if first.type.strip_typedefs().code != gdb.TYPE_CODE_PTR:  # of bool
        return printed(value)
    return elements(first, int(value["_M_impl"]["_M_finish"] - first))


def part(value):
    """Of an array or a struct, which may have a value in a few places only."""
    try:
        return shown(value)
    except NoValue:
        return "?"


def fixed_array(value):
    low, high = value.type.strip_typedefs().range()
    found = [part(value[k]) for k in range(low, min(high + 1, MOST_ELEMENTS))]
    if all(element == "?" for element in found):
        raise NoValue
    return found


def span(value):
    return elements(value["_M_ptr"], int(value["_M_extent"]["_M_extent_value"]))


def optional(value):
    payload = value["_M_payload"]
    if not boolean(payload["_M_engaged"]):
        return "empty"
    return shown(payload["_M_payload"]["_M_value"])


def string(value):
    count = int(value["_M_string_length"])
    if not 0 <= count < 1000:
        raise Hidden
    return value["_M_dataplus"]["_M_p"].string(length=count)


def printed(value):
    """By the printers that come with the library, where there are any."""
    printer = gdb.default_visualizer(value)
    if printer is None or not hasattr(printer, "children"):
        raise Hidden
    found = []
    for _, child in printer.children():
        if len(found) == MOST_ELEMENTS:
            return f"more than {MOST_ELEMENTS} elements"
        found.append(shown(child) if isinstance(child, gdb.Value) else child)
    kind = getattr(printer, "display_hint", lambda: None)()
    return list(map(list, zip(found[::2], found[1::2]))) if kind == "map" else found


def members(value):
    fields = [f for f in value.type.strip_typedefs().fields() if not f.is_base_class]
    if not 0 < len(fields) <= 8:
        raise Hidden
    found = {}
    for field in fields:
        try:
            found[field.name] = part(value[field])
        except Hidden:
            pass  # as a table that it refers to
    if all(inside == "?" for inside in found.values()):
        raise NoValue
    return "{" + ", ".join(f"{name} {as_text(inside)}" for name, inside in
                           found.items()) + "}"


def as_text(value):
    return value if isinstance(value, str) else json.dumps(value)


CLASSES = (
    ("std::vector<", vector),
    ("std::span<", span),
    ("std::optional<", optional),
    ("std::array<", lambda value: shown(value["_M_elems"])),
    ("std::pair<", lambda value: [shown(value["first"]), shown(value["second"])]),
    ("std::__cxx11::basic_string<", string),
    ("std::map<", printed),
    ("std::set<", printed),
    ("std::unordered_", printed),
    ("std::deque<", printed),
    ("std::queue<", printed),
    ("std::stack<", printed),
)
NOT_SHOWN = ("HalfEdgeTable", "IndexedMesh", "FaceList", "WingedMesh", "Anchors")


def of_class(value):
    name = (value.type.strip_typedefs().unqualified().name or "")
    if name.split("::")[-1] in NOT_SHOWN:
        raise Hidden
    for start, show in CLASSES:
        if name.startswith(start):
            return show(value)
    if name.startswith(("std::", "__gnu_cxx::")):
        raise Hidden
    return members(value)


CODES = {
    gdb.TYPE_CODE_INT: integer,
    gdb.TYPE_CODE_CHAR: integer,
    gdb.TYPE_CODE_BOOL: boolean,
    gdb.TYPE_CODE_FLT: real,
    gdb.TYPE_CODE_ENUM: enumerator,
    gdb.TYPE_CODE_ARRAY: fixed_array,
    gdb.TYPE_CODE_STRUCT: of_class,
}


def shown(value):
    kind = value.type.strip_typedefs()
    if kind.code in (gdb.TYPE_CODE_REF, gdb.TYPE_CODE_RVALUE_REF):
        value = value.referenced_value()
        kind = value.type.strip_typedefs()
    if kind.code not in CODES:
        raise Hidden
    return CODES[kind.code](value)


# ---- places


def short_name(function):
    name = function.name.replace("(anonymous namespace)::", "")
    return "lambda" if "operator()" in name else name.split("(")[0].split("::")[-1]


class Variable:
    """A local variable, and where its declaration stands.

    It has no value of its own before its initialiser has run. gdb knows the
    scope of a variable, which begins before that, and the addresses of lines;
    but a line may declare several variables, and has several addresses where it
    calls something or branches. Code is laid out as it is written, so before
    the first of these addresses there is no value yet, and after the last one
    there is. In between it has one from when its bytes change, or from when the
    program goes back, which only the loop after an initialiser does. Watching
    bytes alone would not do: a new value may be the one that was left there."""

    def __init__(self, symbol, block, table, text):
        self.symbol = symbol
        self.line = symbol.line or line_of_binding(symbol.name, text)
        own = declaration(symbol.name, self.line, text)
        inside = [entry for entry in table if entry[0] >= self.line
                  and block.start <= entry[1] < block.end]
        at = next((k for k, (line, _) in enumerate(inside) if line == self.line), 0)
        of_it = inside[at:at + 1]
        for entry in inside[at + 1:]:
            if not self.line <= entry[0] < self.line + len(own):
                break
            of_it.append(entry)
        self.first = of_it[0][1] if of_it else block.end
        self.last = of_it[-1][1] if of_it else block.end
        self.mentions = lines_naming(symbol.name, self.line, text) if (
            is_of_bytes(symbol.type) and is_without_value(own)) else ()

    def may_have_value(self, pc):
        return self.symbol.is_argument or pc > self.first

    def surely_has_value(self, pc):
        return self.symbol.is_argument or (pc > self.last and not self.mentions)


def line_of_binding(name, text):
    """clang does not say where a name of auto [a, b] = ... is declared."""
    binding = re.compile(rf"\bauto\b[^\[;]*\[[^\];]*\b{name}\b")
    return next((k for k, line in enumerate(text, 1) if binding.search(line)), 1)


def declaration(name, line, text):
    """From a name in a line to a comma, a semicolon or the end of a bracket
    that it stands in: the lines of that."""
    start = re.search(rf"\b{name}\b|$", text[line - 1]).end()
    depth = 0
    for end in range(line, min(line + MOST_LINES, len(text)) + 1):
        for k in range(start if end == line else 0, len(text[end - 1])):
            letter = text[end - 1][k]
            depth += (letter in "([{") - (letter in ")]}")
            if depth < 0 or (depth == 0 and letter in ",;"):
                return [text[line - 1][start:], *text[line:end]]
    return [text[line - 1][start:]]


def is_of_bytes(kind):
    """What compilers give to such variables looks like a value."""
    kind = kind.strip_typedefs()
    while kind.code == gdb.TYPE_CODE_ARRAY:
        kind = kind.target().strip_typedefs()
    return kind.sizeof == 1


def is_without_value(lines):
    return re.match(r"\s*(\[[^\]]*\]\s*)*[,;]", lines[0]) is not None


def lines_naming(name, line, text):
    return {k for k, later in enumerate(text[line:], line + 1)
            if re.search(rf"\b{name}\b", later)}


class Place:
    """What is the same each time that an address is reached."""

    def __init__(self, pc, line, variables_of):
        self.pc = pc
        self.line = line
        self.variables = []  # how it is called, and a Variable
        self.not_yet = []    # Variables whose bytes will be asked for
        found = []
        block = gdb.block_for_pc(pc)
        while block is not None and not block.is_global and not block.is_static:
            found += variables_of(block)
            if block.function is not None:
                self.function = short_name(block.function)
                break
            block = block.superblock
        for variable in reversed(found):  # from the outer to the inner ones
            symbol = variable.symbol
            if not variable.may_have_value(pc):
                if variable.last > variable.first or variable.mentions:
                    self.not_yet.append(variable)
                continue
            taken = any(name == symbol.name for name, _ in self.variables)
            name = f"{symbol.name} (line {variable.line})" if taken else symbol.name
            self.variables.append((name, variable))


class Scopes:
    """The variables of blocks, innermost first: the same at all places."""

    def __init__(self, table, text):
        self.table = table
        self.text = text
        self.known = {}

    def variables_of(self, block):
        key = (block.start, block.end)
        if key not in self.known:
            found = [Variable(symbol, block, self.table, self.text)
                     for symbol in block
                     if symbol.is_argument or (symbol.is_variable and
                                               not symbol.name.startswith("__"))]
            self.known[key] = sorted(
                found, key=lambda v: (v.line, v.symbol.name), reverse=True)
        return self.known[key]


def last_value(variable, before, frame):
    """Of a variable whose scope has just been left: its memory is still what it
    was, but for that of classes."""
    if variable.symbol.type.strip_typedefs().code not in (
            gdb.TYPE_CODE_INT, gdb.TYPE_CODE_BOOL, gdb.TYPE_CODE_FLT):
        return before
    try:
        return json.dumps(shown(variable.symbol.value(frame)))
    except (Hidden, gdb.error):
        return before


class Activation:
    """A call of a function: what is known of those of its variables of which
    the address alone does not say whether they have a value."""

    HAS_VALUE = object()

    def __init__(self):
        self.place = None  # the one before
        self.shown = {}    # there: by name, a Variable and its value
        self.known = {}    # of a Variable: HAS_VALUE, or its bytes without one

    def values(self, place, frame):
        for variable in place.not_yet:
            self.known[variable] = bytes_of(variable.symbol.value(frame))
        now = {}
        for name, variable in place.variables:
            try:
                value = variable.symbol.value(frame)
                if (variable.surely_has_value(place.pc) or
                        self.has_value(variable, value, place)):
                    now[name] = (variable, json.dumps(shown(value)))
            except Exception:  # Hidden, or one of the many kinds that gdb has
                pass
        left = {"-" + name: last_value(variable, before, frame)
                for name, (variable, before) in self.shown.items() if name not in now}
        self.place = place
        self.shown = now
        return {name: value for name, (_, value) in now.items()} | left

    def has_value(self, variable, value, place):
        before = self.known.get(variable)
        if before is self.HAS_VALUE:
            return True
        raw = bytes_of(value)
        if variable.mentions and self.place.pc <= variable.last:
            before = raw  # what the compiler gave to it
        goes_back = place.pc < self.place.pc and not variable.mentions
        if raw == before and not goes_back and self.place.line not in variable.mentions:
            self.known[variable] = raw
            return False
        self.known[variable] = self.HAS_VALUE
        return True


# ---- recording


class Recorder:
    def __init__(self):
        self.out = open(os.environ["COURSE_LOCALS"], "w", encoding="utf-8")
        self.most = int(os.environ["COURSE_MOST"])
        self.count_at = None
        self.stops = []
        self.begin()

    def begin(self):
        self.count_of_stops = 0
        self.activations = {}  # by their stack

    def count(self):
        raw = gdb.selected_inferior().read_memory(self.count_at, 8)
        return struct.unpack("Q", raw)[0]

    def reach(self, place):
        """Notes that a place is reached; whether these are enough."""
        frame = gdb.newest_frame()
        stack = int(frame.read_register("fp"))
        activation = self.activations.setdefault(stack, Activation())
        now = activation.values(place, frame)
        fields = [self.count(), place.line, place.pc, stack, place.function]
        for variable in now.items():
            fields += variable
        return self.write(fields)

    def enter(self):
        """A function begins: calls deeper in the stack have ended."""
        stack = int(gdb.newest_frame().read_register("sp"))
        return self.write([self.count(), 0, 0, stack, ""])

    def write(self, fields):
        self.out.write("\t".join(map(str, fields)) + "\n")
        self.count_of_stops += 1
        if self.count_of_stops < self.most:
            return False
        self.out.write(f"{self.count()}\t-1\n")
        return True


class Reached(gdb.Breakpoint):
    """Tells `note` of each time; then the program goes on, or not."""

    def __init__(self, pc, note):
        super().__init__(f"*{pc}", internal=True)
        self.silent = True
        self.note = note

    def stop(self):
        return self.note()


def is_worth_a_stop(text):
    return text.strip().rstrip(";),") not in ("", "}", "{")


def function_at(pc):
    block = gdb.block_for_pc(pc)
    while block is not None and block.function is None:
        block = block.superblock
    return block


def ends_of(entries, text):
    """Of each function that ends in a return, by its start: the first address
    of that. Code after it cleans up: its variables end, one after the other."""
    last = {}
    for line, pc, function in entries:
        if text[line - 1].strip() != "}":
            found = last.get(function.start, (0, 0))
            last[function.start] = max(found, (line, -pc))
    return {start: -pc for start, (line, pc) in last.items()
            if text[line - 1].lstrip().startswith("return")}


def entries_of(path, text):
    """Line, address and function of the source's code, by address."""
    symtab = gdb.decode_line(f'"{path}":1')[1][0].symtab
    entries = [(entry.line, entry.pc, function_at(entry.pc)) for entry in
               sorted(symtab.linetable(), key=lambda entry: entry.pc)]
    return [entry for entry in entries
            if entry[2] is not None and 0 < entry[0] <= len(text)]


def lines_of(entries, text):
    """Pairs of line and address, without the first instructions of functions,
    which have no arguments yet."""
    ends = ends_of(entries, text)
    return [(line, pc) for line, pc, function in entries
            if pc != function.start and is_worth_a_stop(text[line - 1])
            and pc <= ends.get(function.start, pc)]


def closing_brackets(entries, text):
    """Addresses where functions end that do not end in a return."""
    last = {function.start: line for line, _, function in sorted(
        entries, key=lambda entry: entry[0]) if text[line - 1].strip() == "}"}
    ends = ends_of(entries, text)
    first = {}
    for line, pc, function in entries:
        if last.get(function.start) == line and function.start not in ends:
            first.setdefault(function.start, pc)
    return first.values()


def stops_in(path, recorder):
    """Breakpoints at all that is to be noted of a source."""
    with open(path, encoding="utf-8", errors="replace") as file:
        text = file.read().split("\n")
    entries = entries_of(path, text)
    table = lines_of(entries, text)
    scopes = Scopes(table, text)
    ends = [(0, pc) for pc in closing_brackets(entries, text)]
    stops = [Reached(function.start, recorder.enter)
             for function in {f.start: f for _, _, f in entries}.values()]
    for line, pc in table + ends:
        place = Place(pc, line, scopes.variables_of)
        stops.append(Reached(pc, partial(recorder.reach, place)))
    return stops


def main():
    for setting in ("pagination off", "confirm off", "auto-solib-add off",
                    "startup-with-shell off", "breakpoint always-inserted on",
                    "print thread-events off", "print inferior-events off"):
        gdb.execute(f"set {setting}")
    gdb.execute("handle all nostop noprint pass", to_string=True)
    recorder = Recorder()
    begins = gdb.Breakpoint("course_walk_begins", internal=True)
    begins.silent = True
    gdb.execute("run", to_string=True)
    while gdb.selected_inferior().pid != 0:
        if recorder.count_at is None:
            recorder.count_at = int(gdb.parse_and_eval("*(unsigned long*)&course_trace_size"))
            gdb.execute("sharedlibrary submission", to_string=True)
            recorder.stops = stops_in(os.environ["COURSE_FILE"], recorder)
        at_begin = gdb.newest_frame().name() == "course_walk_begins"
        for stop in recorder.stops:
            stop.enabled = at_begin
        if at_begin:
            recorder.out.write("walk\n")
            recorder.begin()
        gdb.execute("continue", to_string=True)
    recorder.out.close()


main()
