"""March: the loop of classical Runge–Kutta steps around a generated right-hand side, as LLVM assembly.

Every stage is (bq + c q̇, bv + c q̈) of the one before; so is the end, with bv = (v₂ + 2 v₃ + v₄ − v₀)/3 and c = h/6.
"""

from __future__ import annotations

from gearwright.dynamics.codegen.driven import DECLARATIONS
from gearwright.dynamics.codegen.emit import splat
from gearwright.dynamics.codegen.generate import slope
from gearwright.dynamics.codegen.instant import instant
from gearwright.dynamics.codegen.parts import SPLIT, slope_in_parts
from gearwright.dynamics.codegen.topology import filled
from gearwright.dynamics.codegen.writer import Writer, record_width, table_width, wave_width
from gearwright.dynamics.equations import WORKS

BLOCK = 64
"""Steps of trajectories side by side between two turns of the tones: so short a table stays in the near caches."""
STAGES = ("q", "v", "qa", "qb", "v2", "v3", "v4", "bq", "bv")
"""Work arrays: the state, positions of stages in turn, velocities of stages two to four, what the last begins from."""


def assembly(writer: Writer) -> str:
    """Return the LLVM assembly of a structure.

    Args:
        writer: Of its functions.
    """
    alone = writer.lanes == 1
    written = slope_in_parts if writer.count > SPLIT else slope
    slopes = [written(writer, "look", "record" if alone else "statistics")]
    slopes += [] if _shared(writer) else [written(writer, "slope", "")]
    laws = [DECLARATIONS] if writer.shape.drives.records else []
    parts = [_DECLARATIONS, *laws, instant(writer), *slopes, _loop(writer)]
    return "\n\n".join([*parts, _alone(writer) if alone else _blocks(writer)])


def _shared(writer: Writer) -> bool:
    """Tell whether all stages of a step run the code of the first, so that half as much is compiled and fetched."""
    return writer.lanes == 1 and writer.count > SPLIT


_DECLARATIONS = """declare double @llvm.fabs.f64(double)
declare <8 x double> @llvm.fabs.v8f64(<8 x double>)
declare <16 x float> @llvm.fabs.v16f32(<16 x float>)
declare <8 x double> @llvm.minnum.v8f64(<8 x double>, <8 x double>)
declare <8 x double> @llvm.maxnum.v8f64(<8 x double>, <8 x double>)
declare <16 x float> @llvm.minnum.v16f32(<16 x float>, <16 x float>)
declare <16 x float> @llvm.maxnum.v16f32(<16 x float>, <16 x float>)
declare void @llvm.memcpy.inline.p0.p0.i64(ptr, ptr, i64, i1)
declare void @llvm.memcpy.p0.p0.i64(ptr, ptr, i64, i1)
declare void @llvm.memset.p0.i64(ptr, i8, i64, i1)"""


def _loop(writer: Writer) -> str:
    """Return the function that takes the steps."""
    shape, lanes = writer.shape, writer.lanes
    slope_name = "unseen" if _shared(writer) else "slope"
    row, numbers = table_width(shape, writer.clocks, writer.width), shape.size * lanes
    stride = record_width(shape) if lanes == 1 else 0
    keep = (
        [*_moved(writer, "%place", 0, "%q", numbers), *_moved(writer, "%place", numbers, "%v", numbers)]
        if lanes == 1
        else []
    )
    pointers = ", ".join(f"ptr noalias %{name}" for name in ("p", "own", "table", "turn", "state", "out"))
    name = "void @advance" if lanes == 1 else "internal void @march"
    return f"""define {name}(i64 %steps, {pointers}) {{
entry:
{_arrays(writer, STAGES, STAGES)}
{_lines(*_copies(writer, "%state", ("q", "v", "works"), inwards=True))}
  %one = load {writer.kind}, ptr %p, align 8
  %lone = insertelement {writer.vector} poison, {writer.kind} %one, i64 0
  %h = shufflevector {writer.vector} %lone, {writer.vector} poison, <{writer.width} x i32> zeroinitializer
  %half = fmul {writer.vector} %h, {splat(0.5, lanes)}
  %third = fmul {writer.vector} %h, {splat(1.0 / 3.0, lanes)}
  %sixth = fmul {writer.vector} %h, {splat(1.0 / 6.0, lanes)}
  {_instant("%table")}
  br label %head
head:
  %i = phi i64 [0, %entry], [%next, %head]
  %twice = mul i64 %i, {2 * row}
  %row0 = getelementptr {writer.kind}, ptr %table, i64 %twice
  %row1 = getelementptr {writer.kind}, ptr %row0, i64 {row}
  %row2 = getelementptr {writer.kind}, ptr %row1, i64 {row}
  %offset = mul i64 %i, {stride}
  %place = getelementptr {writer.kind}, ptr %out, i64 %offset
  %seen = getelementptr {writer.kind}, ptr %place, i64 {2 * numbers if lanes == 1 else 0}
{_lines(*keep)}
  {_stage(writer, "look", "%row0", "q v q v qa v2", c="%half", share="%sixth")}
  {_instant("%row1")}
  {_stage(writer, slope_name, "%row1", "q v qa v2 qb v3", c="%half", share="%third")}
  {_stage(writer, slope_name, "%row1", "q v qb v3 qa v4", c="%h", share="%third")}
{_last_base(writer)}
  {_instant("%row2")}
  {_stage(writer, slope_name, "%row2", "bq bv qa v4 q v", c="%sixth", share="%sixth")}
  %next = add i64 %i, 1
  %more = icmp slt i64 %next, %steps
  br i1 %more, label %head, label %done
done:
{_lines(*_copies(writer, "%state", ("q", "v", "works"), inwards=False))}
  ret void
}}"""


def _blocks(writer: Writer) -> str:
    """Return the function that takes the steps of trajectories side by side, each block with its turn of the tones."""
    names = ("p", "own", "table", "turn", "state", "out")
    pointers, given = (", ".join(f"{kind} %{name}" for name in names) for kind in ("ptr noalias", "ptr"))
    return f"""define void @advance(i64 %steps, {pointers}) {{
entry:
  br label %head
head:
  %first = phi i64 [0, %entry], [%next, %head]
  %next = add i64 %first, {BLOCK}
  %left = sub i64 %steps, %first
  %short = icmp slt i64 %left, {BLOCK}
  %count = select i1 %short, i64 %left, i64 {BLOCK}
  %number = udiv i64 %first, {BLOCK}
  %far = mul i64 %number, {2 * writer.waves}
  %turned = getelementptr {writer.kind}, ptr %turn, i64 %far
  call void @march(i64 %count, {given.replace("%turn,", "%turned,")})
  %more = icmp slt i64 %next, %steps
  br i1 %more, label %head, label %done
done:
  ret void
}}"""


def _alone(writer: Writer) -> str:
    """Return the function that works out one derivative, for steps of any length: a stage from nothing with c = 1."""
    wave, room = wave_width(writer.shape), _room(writer)
    turn = ", ".join([f"double {1.0 if i < wave else 0.0}" for i in range(2 * wave)])
    pointers = ", ".join(f"ptr noalias %{name}" for name in ("p", "row", "y", "dy", "seen"))
    stage = _stage(writer, "look", "%row", "bq bv q v qa v2", c=splat(1.0), share=splat(1.0))
    body = "\n  ".join([_instant("%row"), stage]).replace("%own", "%p").replace("%turn", "@unturned")
    return f"""@unturned = private constant [{2 * wave} x double] [{turn}], align 64
@nothing = private constant [{room} x double] zeroinitializer, align 64

define void @derivative({pointers}) {{
{_arrays(writer, ("q", "v", "qa", "v2"), ("works",))}
{_lines(*_copies(writer, "%y", ("q", "v"), inwards=True))}
  {body.replace("%bq", "@nothing").replace("%bv", "@nothing")}
{_lines(*_copies(writer, "%dy", ("qa", "v2", "works"), inwards=False))}
  ret void
}}"""


def _arrays(writer: Writer, names: tuple[str, ...], cleared: tuple[str, ...]) -> str:
    """Return work arrays, some of them cleared; what fills up the others to whole vectors does not matter."""
    shape, lanes = writer.shape, writer.lanes
    rooms = dict.fromkeys(names, _room(writer))
    rooms |= {"works": filled(WORKS * lanes), "now": 4 * filled(len(shape.lines) * lanes)}
    rooms["wave"] = 4 * writer.waves
    rooms |= {"unwanted": record_width(shape)} if _shared(writer) else {}
    lines = [f"%{name} = alloca [{room} x {writer.kind}], align 64" for name, room in rooms.items()]
    size = 64 // writer.width
    lines += [
        f"call void @llvm.memset.p0.i64(ptr %{name}, i8 0, i64 {size * rooms[name]}, i1 false)" for name in cleared
    ]
    return _lines(*lines)


def _room(writer: Writer) -> int:
    """Return the numbers of a work array: one for each coordinate, and in velocities the drives' states after them."""
    return filled(writer.shape.size * writer.lanes) + filled(writer.shape.drives.states)


def _copies(writer: Writer, state: str, names: tuple[str, ...], *, inwards: bool) -> list[str]:
    """Return the copies between a state (q, q̇, works, drives) and work arrays; works that are not named stay."""
    shape, numbers, works = writer.shape, writer.shape.size * writer.lanes, WORKS * writer.lanes
    arrays = {f"%{name}": number * numbers for number, name in enumerate(names)}
    x = f"%{'in' if inwards else 'out'}.x"
    lines = [f"{x} = getelementptr {writer.kind}, ptr %{names[1]}, i64 {filled(numbers)}"]
    for name, first in arrays.items():
        lines += _moved(writer, state, first, name, works if name == "%works" else numbers, back=inwards)
    return lines + _moved(writer, state, 2 * numbers + works, x, shape.drives.states, back=inwards)


def _moved(writer: Writer, base: str, first: int, array: str, count: int, *, back: bool = False) -> list[str]:
    """Return the copy of an array to a place in another, or back."""
    place = f"%{'in' if back else 'out'}.{base[1:]}.{array[1:]}"
    pair = (array, place) if back else (place, array)
    return [f"{place} = getelementptr {writer.kind}, ptr {base}, i64 {first}", _copy(*pair, count * 64 // writer.width)]


def _copy(to: str, source: str, size: int) -> str:
    kind = "memcpy.inline" if size <= 512 else "memcpy"
    return f"call void @llvm.{kind}.p0.p0.i64(ptr {to}, ptr {source}, i64 {size}, i1 false)"


def _instant(row: str) -> str:
    return f"call void @instant(ptr %p, ptr %own, ptr {row}, ptr %turn, ptr %wave, ptr %now)"


def _stage(writer: Writer, name: str, row: str, arrays: str, *, c: str, share: str) -> str:
    """Return the call of a slope on arrays, with names as `generate.slope` orders them from ``bq`` on."""
    name, seen = ("look", "%unwanted") if name == "unseen" else (name, "%seen")
    pointers = ", ".join(f"ptr {at}" for at in ("%p", "%own", row, "%now", *(f"%{name}" for name in arrays.split())))
    return f"call void @{name}({pointers}, ptr %works, ptr {seen}, {writer.vector} {c}, {writer.vector} {share})"


def _last_base(writer: Writer) -> str:
    """The last stage begins from: bq = q + h/6 (v + 2 v₂ + 2 v₃), bv = v + (d₂ + 2 d₃ + d₄)/3, dᵢ = vᵢ − v."""
    lines, kind, third = list[str](), writer.vector, splat(1.0 / 3.0, writer.lanes)
    two, flags = splat(2.0, writer.lanes), f"contract {kind}"
    for i in range(0, _room(writer), writer.width):
        for name in ("q", "v", "v2", "v3", "v4", "bq", "bv"):
            lines.append(f"%p{name}.{i} = getelementptr {writer.kind}, ptr %{name}, i64 {i}")
        for name in ("q", "v", "v2", "v3", "v4"):
            lines.append(f"%l{name}.{i} = load {kind}, ptr %p{name}.{i}, align 64")
        lines += [
            f"%twice{i} = fmul contract {kind} %lv3.{i}, {two}",
            f"%inner{i} = fadd contract {kind} %lv2.{i}, %twice{i}",
            f"%middle{i} = fadd {kind} %lv2.{i}, %inner{i}",
            f"%sum{i} = fadd {kind} %lv.{i}, %middle{i}",
            f"%gone{i} = fmul {flags} %sixth, %sum{i}",
            f"%to{i} = fadd {flags} %lq.{i}, %gone{i}",
            f"store {kind} %to{i}, ptr %pbq.{i}, align 64",
            *(f"%d{n}.{i} = fsub {kind} %lv{n}.{i}, %lv.{i}" for n in (2, 3, 4)),  # small, so that rounding is too
            f"%both{i} = fmul contract {kind} %d3.{i}, {two}",
            f"%ends{i} = fadd {kind} %d2.{i}, %d4.{i}",
            f"%all{i} = fadd contract {kind} %both{i}, %ends{i}",
            f"%third{i} = fmul {flags} %all{i}, {third}",
            f"%mean{i} = fadd {flags} %lv.{i}, %third{i}",
            f"store {kind} %mean{i}, ptr %pbv.{i}, align 64",
        ]
    return _lines(*lines)


def _lines(*lines: str) -> str:
    return "\n".join(f"  {line}" for line in lines)
