"""Natural frequencies of a published planetary set with translations, by family.

Lin & Parker 1999, J. Vib. Acoust. 121, 316-321, table 1: four planets, pressure angle 24.6°. Their data are I/r² and
stiffnesses in u = r θ.
"""

from math import radians

from gearwright.dynamics import Model, modes
from gearwright.dynamics.model import Member, PlanetarySet, add_planetary
from gearwright.dynamics.vibration import mode_families
from gearwright.parts.planetary import even_positions
from gearwright.parts.stiffness import StiffnessCurve


def member(mass, inertia, diameter, turn=0.0):
    return Member(mass, inertia * diameter**2 / 4.0, diameter / 2.0, support=1e8, torsion=turn * diameter**2 / 4.0)


sun, ring = member(0.4, 0.39, 0.07742), member(2.35, 3.0, 0.27503, turn=1e9)
carrier, planet = member(5.43, 6.29, 0.1768), member(0.66, 0.61, 0.10035)
mesh, angle, places = StiffnessCurve(5e8), radians(24.6), even_positions(4)
model = Model()
add_planetary(model, PlanetarySet(sun, ring, carrier, planet, mesh, mesh, (angle, angle), places))
found = modes(system := model.build())
families = mode_families(system, found, places)
for family in ("rotational", "translational", "planet"):
    print(f"{family:14}", *(f"{f:.1f}" for f, each in zip(found.frequency, families, strict=True) if each == family))
