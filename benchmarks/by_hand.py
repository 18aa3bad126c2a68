"""What a patient user writes by hand: RK4 in numba over sparse lines, and straight-line C for one system.

The C is a bound rather than a peer: its numbers are constants. Without duties it keeps no record but the grid's, no
statistics and no book of energies; with them it does what our stepper does: a row of states, line forces and
deflections for each step, least, most, sum and sum of squares of each column, and five works by the scheme's weights.
"""

from __future__ import annotations

import ctypes
import hashlib
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numba import njit
from peers import Case, line_forces_of

from gearwright.dynamics.model import Arrays

FLAGS = ("-O3", "-march=native", "-ffast-math", "-shared", "-fPIC")


def numba_fill(arrays: Arrays) -> Callable:
    """Return what fills dy/dt from the cosines and sines of the tones, without an allocation."""
    push, mean = line_forces_of(arrays), arrays.stiffness
    mobility, constant, size = 1.0 / arrays.mass, arrays.loads.constant, len(arrays.mass)

    @njit(error_model="numpy", fastmath=True, inline="always")
    def fill(cos, sin, y, out):
        for i in range(size):
            out[i], out[size + i] = y[size + i], constant[i]
        push(cos, sin, y, mean, out)
        for i in range(size):
            out[size + i] *= mobility[i]

    return fill


def numba_rk4(case: Case, setting: float) -> Callable[[], np.ndarray]:
    """RK4 in one compiled loop, trigonometry once for each half step; setting: steps in an interval of the grid."""
    fill, rate, count = numba_fill(case.arrays), case.arrays.tone_rate, len(case.start)
    steps, intervals = int(setting), case.intervals
    h = case.duration / (intervals * steps)

    @njit(error_model="numpy", fastmath=True)
    def whole(begin):
        rows = np.empty((intervals + 1, count))
        y, z, total, k = begin.copy(), np.empty(count), np.empty(count), np.empty(count)
        cos, sin = np.ones(len(rate)), np.zeros(len(rate))
        rows[0] = y
        for number in range(intervals * steps):
            total[:], z[:] = 0.0, y
            for stage in range(4):
                if stage % 2 == 1:
                    for i in range(len(rate)):
                        angle = rate[i] * (number + 0.5 * (stage + 1) / 2) * h
                        cos[i], sin[i] = np.cos(angle), np.sin(angle)
                fill(cos, sin, z, k)
                share, reach = (1.0, 2.0, 2.0, 1.0)[stage], (0.5, 0.5, 1.0, 0.0)[stage] * h
                for i in range(count):
                    total[i] += share * k[i]
                    z[i] = y[i] + reach * k[i]
            for i in range(count):
                y[i] += h / 6.0 * total[i]
            if (number + 1) % steps == 0:
                rows[(number + 1) // steps] = y
        return rows

    return lambda: whole(case.start)


def c_rk4_duties(case: Case, setting: float) -> Callable[[], np.ndarray]:
    """RK4 as straight-line C with all that our stepper does; setting: steps in an interval of the grid."""
    return c_rk4(case, setting, duties=True)


def c_rk4(case: Case, setting: float, *, duties: bool = False) -> Callable[[], np.ndarray]:
    """RK4 as straight-line C, tones turned from half step to half step; setting: steps in an interval of the grid."""
    h = case.duration / (case.intervals * int(setting))
    text = _source_of_duties(case.arrays, h) if duties else _source(case.arrays, h)
    folder = Path(tempfile.gettempdir()) / "gearwright-benchmarks"
    folder.mkdir(exist_ok=True)
    library = folder / f"{hashlib.sha256(text.encode()).hexdigest()[:16]}.so"
    if not library.exists():
        subprocess.run(["gcc", *FLAGS, "-x", "c", "-", "-o", str(library), "-lm"], input=text.encode(), check=True)
    run = ctypes.CDLL(str(library)).whole
    start = np.ascontiguousarray(case.start)

    def go() -> np.ndarray:
        rows = np.empty((case.intervals + 1, len(start)))
        run(ctypes.c_void_p(start.ctypes.data), ctypes.c_void_p(rows.ctypes.data), case.intervals, int(setting))
        return rows

    return go


def _source(arrays: Arrays, h: float) -> str:
    """Return the C of one system at one step."""
    size, tones = len(arrays.mass), len(arrays.tone_rate)
    rates = ",".join(map(repr, arrays.tone_rate.tolist()))
    return f"""#include <math.h>
#include <string.h>
static const double W[]={{{rates}}};
static inline void slope(const double*c,const double*s,const double*q,const double*v,double*a){{
{_slope(arrays)}}}
static inline void turn(double*c,double*s,const double*rc,const double*rs){{
 for(int i=0;i<{tones};i++){{double x=c[i]*rc[i]-s[i]*rs[i];s[i]=s[i]*rc[i]+c[i]*rs[i];c[i]=x;}}}}
void whole(const double*restrict y,double*restrict rows,int intervals,int steps){{
 const double h={h!r};long step=0;
 double q[{size}],v[{size}],z[{size}],v2[{size}],v3[{size}],v4[{size}],a1[{size}],a2[{size}],a3[{size}],a4[{size}];
 double c[{tones}],s[{tones}],rc[{tones}],rs[{tones}];
 memcpy(q,y,sizeof q);memcpy(v,y+{size},sizeof v);memcpy(rows,y,sizeof q+sizeof v);
 for(int i=0;i<{tones};i++){{rc[i]=cos(W[i]*h/2);rs[i]=sin(W[i]*h/2);}}
 for(int m=0;m<intervals;m++){{
  for(int n=0;n<steps;n++,step++){{
   if(step%64==0)for(int i=0;i<{tones};i++){{c[i]=cos(W[i]*step*h);s[i]=sin(W[i]*step*h);}}
   slope(c,s,q,v,a1);turn(c,s,rc,rs);
   for(int i=0;i<{size};i++){{z[i]=q[i]+h/2*v[i];v2[i]=v[i]+h/2*a1[i];}}
   slope(c,s,z,v2,a2);
   for(int i=0;i<{size};i++){{z[i]=q[i]+h/2*v2[i];v3[i]=v[i]+h/2*a2[i];}}
   slope(c,s,z,v3,a3);turn(c,s,rc,rs);
   for(int i=0;i<{size};i++){{z[i]=q[i]+h*v3[i];v4[i]=v[i]+h*a3[i];}}
   slope(c,s,z,v4,a4);
   for(int i=0;i<{size};i++){{q[i]+=h/6*(v[i]+2*v2[i]+2*v3[i]+v4[i]);v[i]+=h/6*(a1[i]+2*a2[i]+2*a3[i]+a4[i]);}}}}
  memcpy(rows+(m+1)*{2 * size},q,sizeof q);memcpy(rows+(m+1)*{2 * size}+{size},v,sizeof v);}}}}
"""


def _source_of_duties(arrays: Arrays, h: float) -> str:
    """Return the C that also keeps rows, statistics and works."""
    plain = _source(arrays, h)
    size, lines = len(arrays.mass), len(arrays.stiffness)
    width = 2 * (size + lines)
    signature = "const double*c,const double*s,const double*q,const double*v,double*a"
    more = f"{signature},double*restrict o,double*restrict w,double share"
    text = plain.replace(f"slope({signature}){{\n{_slope(arrays)}", f"slope({more}){{\n{_slope(arrays, duties=True)}")
    for stage, (place, share) in enumerate(((1, "h/6"), (2, "h/3"), (3, "h/3"), (4, "h/6"))):
        seen = f"row+{2 * size}" if stage == 0 else "rest"
        text = text.replace(f",a{place});", f",a{place},{seen},w,{share});")
    begin = f"memcpy(row,q,sizeof q);memcpy(row+{size},v,sizeof v);\n   slope(c,s,q,v,a1"
    text = text.replace("slope(c,s,q,v,a1", begin)
    # All are visible outside, so that the compiler leaves out nothing.
    rows = f"double block[512*{width}],least[{width}],most[{width}],sum[{width}],square[{width}],works[5];\n"
    text = text.replace("void whole(", f"{rows}void whole(")
    text = text.replace("const double h=", f"double w[5]={{0}},rest[{2 * lines}];const double h=")
    text = text.replace("   if(step%64==0)", f"   double*row=block+(step%512)*{width};\n   if(step%64==0)")
    count = f"""
   if(step%512==511)for(int r=0;r<512;r++)for(int j=0;j<{width};j++){{double x=block[r*{width}+j];
    least[j]=x<least[j]?x:least[j];most[j]=x>most[j]?x:most[j];sum[j]+=x;square[j]+=x*x;}}}}
  memcpy(rows+(m+1)"""
    text = text.replace("}\n  memcpy(rows+(m+1)", count, 1)
    return text.replace("v,sizeof v);}}\n", "v,sizeof v);}memcpy(works,w,sizeof w);}\n")


def _slope(arrays: Arrays, *, duties: bool = False) -> str:
    """Return the statements that fill the accelerations."""
    series, lines, force = (
        (arrays.variation, arrays.error),
        list[str](),
        [[repr(x)] for x in arrays.loads.constant.tolist()],
    )
    for j, mean in enumerate(arrays.stiffness.tolist()):
        entries = range(arrays.line_start[j], arrays.line_start[j + 1])
        pairs = [(float(arrays.line_weight[i]), int(arrays.line_dof[i])) for i in entries]
        d, v = ("+".join(f"({weight!r})*{name}[{dof}]" for weight, dof in pairs) for name in "qv")
        k = repr(mean)
        for part, scale in zip(series, (mean, 1.0), strict=True):
            for i in range(part.start[j], part.start[j + 1]):
                tone, a, b = int(part.tone[i]), float(part.cosine[i]) * scale, float(part.sine[i]) * scale
                rate = float(arrays.tone_rate[tone])
                if part is arrays.variation:
                    k += f"+({a!r})*c[{tone}]+({b!r})*s[{tone}]"
                else:
                    d += f"-({a!r})*c[{tone}]-({b!r})*s[{tone}]"
                    v += f"-({b * rate!r})*c[{tone}]+({a * rate!r})*s[{tone}]"
        if duties:
            lines.append(_works(arrays, j))
        gap = float(arrays.backlash[j])
        both = f"(d{j}>0?d{j}:0)+(d{j}+{gap!r}<0?d{j}+{gap!r}:0)" if gap > 0.0 else f"d{j}"
        damper = float(arrays.damping[j])
        lines.append(f" double d{j}={d},u{j}={v},g{j}={both};double f{j}=({k})*g{j}+{damper!r}*(u{j});")
        if duties:
            lines[-2:] = [lines[-1], lines[-2]]
            lines.append(f" o[{j}]=f{j};o[{j + len(arrays.stiffness)}]=d{j};")
        for weight, dof in pairs:
            force[dof].append(f"-({weight!r})*f{j}")
    for i, load in enumerate(arrays.loads.constant.tolist()):
        if duties and load:
            power = f"{load!r}*({float(arrays.speed[i])!r}+v[{i}])"
            lines.append(f" {{double p={power};w[0]+=share*(p>0?p:0);w[1]-=share*(p<0?p:0);}}")
    lines += [f" a[{i}]=({''.join(parts)})*{1.0 / float(arrays.mass[i])!r};" for i, parts in enumerate(force)]
    return "\n".join(lines) + "\n"


def _works(arrays: Arrays, j: int) -> str:
    """Return what a line adds to the works: of its damper, of its changing stiffness, of its error."""
    slopes = []
    for part, scale in ((arrays.variation, float(arrays.stiffness[j])), (arrays.error, 1.0)):
        terms = ["0"]
        for i in range(part.start[j], part.start[j + 1]):
            tone, rate = int(part.tone[i]), float(arrays.tone_rate[part.tone[i]]) * scale
            terms.append(f"({float(part.sine[i]) * rate!r})*c[{tone}]-({float(part.cosine[i]) * rate!r})*s[{tone}]")
        slopes.append("+".join(terms))
    damper = float(arrays.damping[j])
    return f" w[2]+=share*{damper!r}*u{j}*u{j};w[3]+=share*0.5*({slopes[0]})*g{j}*g{j};w[4]-=share*({slopes[1]})*f{j};"
