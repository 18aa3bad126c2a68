"""Where the force of a mesh with backlash jumps, and where no period closes: numbers, a run, a figure and a page.

The pair of Kahraman and Singh 1990, J. Sound Vib. 142, 49: in units of the stiffness and mass of the mesh, damping
ratio 0.05, mean load 0.1, half of the backlash 1; a transmission error shakes it once in a turn of the clock.
"""

import sys
from pathlib import Path

import numpy as np

import gearwright as gw
from gearwright.dynamics import DampingRatio, Outputs, Periodic
from gearwright.render import style as theme

STEPS, SETTLE, KEPT = 128, 60, 60
"""Steps in a period; periods that are left out, and that are kept."""


def pair(speed, error):
    """Return the mesh under an error of one wave in a turn."""
    model = gw.Model()
    model.rotation("clock", inertia=1.0, speed=speed)
    model.rotation("gear", inertia=1.0, speed=0.0)
    model.mesh("mesh", {"gear": 1.0}, stiffness=1.0, damping=DampingRatio(0.05), backlash=2.0,
               errors=[Periodic({"clock": 1}, (error,))])  # fmt: skip
    model.load("gear", constant=0.1)
    return model.build()


def sweep(speeds, error):
    """Return the run at each speed; each begins with the state in which the one before ended."""
    state, runs = "static", []
    for speed in speeds:
        period = 2.0 * np.pi / speed
        kept = Outputs(start=SETTLE * period, windows=((SETTLE * period, (SETTLE + KEPT) * period),))
        runs.append(gw.simulate(pair(speed, error), (SETTLE + KEPT) * period, step=period / STEPS, start=state,
                                method="runge-kutta", outputs=kept))  # fmt: skip
        state = runs[-1].windows[0].position[-1], runs[-1].windows[0].velocity[-1]
    return runs


def swing(runs):
    """Return the root mean square of the mesh force of each run."""
    return np.array([run.force.of("mesh")["rms"][0] for run in runs])


def main():
    """Answer the question, and write what answers it into a folder."""
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    speeds = np.linspace(0.4, 1.3, 46)
    up, down = swing(sweep(speeds, 0.1)), swing(sweep(speeds[::-1], 0.1))[::-1]
    apart = speeds[np.abs(up - down) > 0.01 * up]
    print(f"two forces from {apart[0]:.2f} to {apart[-1]:.2f} of the natural frequency, error 0.1")
    runs = sweep(speeds, 0.3)
    wild = np.array([any(note.startswith("chaotic") for note in run.notes) for run in runs])
    print(f"chaotic at {wild.sum()} of {len(speeds)} speeds, error 0.3: {speeds[wild].min():.2f} the slowest")
    figure, ((jump, strobe),) = theme.tiles(2, 2, frame=20.0, row=70.0)
    jump.plot(speeds, up, color=theme.BLUE, label="speed rises")
    jump.plot(speeds, down, color=theme.ORANGE, label="speed falls")
    jump.set(xlabel="speed over natural frequency [-]", ylabel="rms of the mesh force [-]")
    jump.set_title("Error 0.1: two forces at one speed")
    jump.legend()
    for speed, run in zip(speeds, runs, strict=True):
        seen = run.windows[0].deflection("mesh")[::STEPS]
        strobe.scatter(np.full(len(seen), speed), seen, np.full(len(seen), 2.0), color=theme.BLUE)
    strobe.set(xlabel="speed over natural frequency [-]", ylabel="deflection once a period [-]")
    strobe.set_title("Error 0.3: one point is a period that closes")
    table = np.column_stack([speeds, up, down, swing(runs), wild])
    np.savetxt(folder / "backlash.csv", table, "%.6g", ",", header="speed,up,down,larger_error,chaotic", comments="")
    gw.save(runs[int(np.argmax(wild))], folder / "backlash.nc")
    figure.savefig(folder / "backlash.svg")
    words = (__doc__ or "").split("\n\n")
    page = f"<!doctype html><meta charset=utf-8><title>Backlash</title><h1>{words[0]}</h1><p>{words[1]}</p>"
    (folder / "backlash.html").write_text(page + figure._repr_html_(), encoding="utf-8")


if __name__ == "__main__":
    main()
