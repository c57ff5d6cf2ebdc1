# Run inside gdb: the lines that a traced submission reaches, and its local
# variables there. Beside each stands how many uses of the table the recorder
# has counted so far, so that both records fit together exactly.
#
# Environment: COURSE_FILE the source as it was compiled, COURSE_LOCALS the file
# to write, COURSE_MOST how many lines of a walk are kept. Of each walk a line
# "walk", then lines of fields with tabs between: count, line, address, function,
# and for each variable that changed its name and its value as JSON ("null": it is
# gone).
import json
import os
import struct

import gdb

MOST_ELEMENTS = 40
PATTERNS = (0xFE, 0xAA)  # what g++ and clang give to variables without a value


class Hidden(Exception):
    """There is nothing to show of this value."""


# ---- values


def integer(value):
    if value.type.sizeof > 1 and is_pattern(value):
        raise Hidden
    return int(value)


def real(value):
    if is_pattern(value):
        raise Hidden
    return float(value)


def boolean(value):
    if int(value) > 1:
        raise Hidden
    return int(value) != 0


def is_pattern(value):
    if value.address is None:
        return False
    size = value.type.sizeof
    raw = bytes(gdb.selected_inferior().read_memory(int(value.address), size))
    return any(raw == bytes([byte]) * size for byte in PATTERNS)


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


def fixed_array(value):
    low, high = value.type.range()
    return [shown(value[k]) for k in range(low, min(high + 1, MOST_ELEMENTS))]


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
    inside = [f"{f.name} {as_text(shown(value[f]))}" for f in fields]
    return "{" + ", ".join(inside) + "}"


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
    return "lambda" if "{lambda" in name else name.split("(")[0].split("::")[-1]


class Place:
    """What is the same each time that an address is reached."""

    def __init__(self, pc, line, table, text):
        self.pc = pc
        self.line = line
        self.variables = []  # how it is called, and its symbol
        found = []
        block = gdb.block_for_pc(pc)
        while block is not None and not block.is_global and not block.is_static:
            found += sorted((symbol for symbol in block
                             if is_initialised(symbol, block, pc, table, text)),
                            key=lambda symbol: (symbol.line, symbol.name),
                            reverse=True)
            if block.function is not None:
                self.function = short_name(block.function)
                break
            block = block.superblock
        for symbol in reversed(found):  # from the outer to the inner ones
            taken = any(name == symbol.name for name, _ in self.variables)
            name = f"{symbol.name} (line {symbol.line})" if taken else symbol.name
            self.variables.append((name, symbol))

    def values(self, frame):
        now = {}
        for name, symbol in self.variables:
            try:
                now[name] = json.dumps(shown(symbol.value(frame)))
            except (Hidden, gdb.error, UnicodeError, struct.error):
                pass
        return now


def is_initialised(symbol, block, pc, table, text):
    """At an address after those of its declaration: code is laid out as it is
    written. Those of a for come again after its first one."""
    if symbol.is_argument:
        return True
    if not symbol.is_variable or symbol.name.startswith("__"):
        return False
    inside = [(line, at) for line, at in table
              if line >= symbol.line and block.start <= at < block.end]
    if not inside:
        return False
    k = next((k for k, (line, _) in enumerate(inside) if line == symbol.line), 0)
    if not text[symbol.line - 1].lstrip().startswith("for"):
        while k + 1 < len(inside) and inside[k + 1][0] == inside[k][0]:
            k += 1
    return pc > inside[k][1]


# ---- recording


class Recorder:
    def __init__(self):
        self.out = open(os.environ["COURSE_LOCALS"], "w", encoding="utf-8")
        self.most = int(os.environ["COURSE_MOST"])
        self.count_at = None
        self.lines = []
        self.begin()

    def begin(self):
        self.stops = 0
        self.last = {}
        self.function = None

    def count(self):
        raw = gdb.selected_inferior().read_memory(self.count_at, 8)
        return struct.unpack("Q", raw)[0]

    def stop(self, place):
        """Notes that a place is reached; whether these are enough."""
        now = place.values(gdb.newest_frame())
        fields = [str(self.count()), str(place.line), str(place.pc), place.function]
        for name, value in now.items():
            if self.last.get(name) != value:
                fields += [name, value]
        for name in self.last:
            if name not in now:
                fields += [name, "null"]
        self.last = now
        self.out.write("\t".join(fields) + "\n")
        self.stops += 1
        return self.stops >= self.most


class LineReached(gdb.Breakpoint):
    def __init__(self, place, recorder):
        super().__init__(f"*{place.pc}", internal=True)
        self.silent = True
        self.place = place
        self.recorder = recorder

    def stop(self):
        return self.recorder.stop(self.place)


def is_worth_a_stop(text):
    return text.strip().rstrip(";),") not in ("", "}", "{")


def function_at(pc):
    block = gdb.block_for_pc(pc)
    while block is not None and block.function is None:
        block = block.superblock
    return block


def ends_of(entries, text):
    """Of each function that ends in a return, by its start: the last address
    of that. Code after it cleans up when something is thrown."""
    last = {}
    for line, pc, function in entries:
        if text[line - 1].strip() != "}":
            found = last.get(function.start, (0, 0))
            last[function.start] = max(found, (line, pc))
    return {start: pc for start, (line, pc) in last.items()
            if text[line - 1].lstrip().startswith("return")}


def lines_of(path, text):
    """Pairs of line and address of the source's code, without the first
    instructions of functions, which have no arguments yet."""
    symtab = gdb.decode_line(f'"{path}":1')[1][0].symtab
    entries = [(entry.line, entry.pc, function_at(entry.pc)) for entry in
               sorted(symtab.linetable(), key=lambda entry: entry.pc)]
    entries = [entry for entry in entries
               if entry[2] is not None and 0 < entry[0] <= len(text)]
    ends = ends_of(entries, text)
    return [(line, pc) for line, pc, function in entries
            if pc != function.start and is_worth_a_stop(text[line - 1])
            and pc <= ends.get(function.start, pc)]


def places_of(path):
    with open(path, encoding="utf-8", errors="replace") as file:
        text = file.read().split("\n")
    table = lines_of(path, text)
    return [Place(pc, line, table, text) for line, pc in table]


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
            recorder.lines = [LineReached(place, recorder)
                              for place in places_of(os.environ["COURSE_FILE"])]
        at_begin = gdb.newest_frame().name() == "course_walk_begins"
        for line in recorder.lines:
            line.enabled = at_begin
        if at_begin:
            recorder.out.write("walk\n")
            recorder.begin()
        gdb.execute("continue", to_string=True)
    recorder.out.close()


main()
