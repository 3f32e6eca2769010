"""Rate of spread of a fuel model without wind and slope, and the fuel models of the built-in legends.

Rothermel 1972 (doi 10.2737/INT-RP-115) as in Albini 1976 and Andrews 2018 (doi 10.2737/RMRS-GTR-371). Models: Anderson
1982, Scott and Burgan 2005 (doi 10.2737/RMRS-GTR-153), Fernandes et al. 2009.
"""

import math

#: Moisture of dead fuel of 1, 10 and 100 hours, of grass and of live wood.
DRY_SUMMER = (0.06, 0.07, 0.08, 0.60, 0.90)
_DENSITY, _MINERAL, _SILICA_FREE = 32.0, 0.0555, 0.010

# Loads [lb/ft2] of 1, 10, 100 hours, grass, live wood; surface to volume [1/ft] of 1 hour, grass, live wood; depth
# [ft]; moisture of extinction [%]; heat [Btu/lb]; whether grass cures.
_AMERICAN = """
1,0.034,0,0,0,0,3500,9999,9999,1,12,8000,0
2,0.092,0.046,0.023,0.023,0,3000,1500,9999,1,15,8000,0
3,0.138,0,0,0,0,1500,9999,9999,2.5,25,8000,0
4,0.23,0.184,0.092,0,0.23,2000,9999,1500,6,20,8000,0
5,0.046,0.023,0,0,0.092,2000,9999,1500,2,20,8000,0
6,0.069,0.115,0.092,0,0,1750,9999,9999,2.5,25,8000,0
7,0.052,0.086,0.069,0,0.017,1750,9999,1550,2.5,40,8000,0
8,0.069,0.046,0.115,0,0,2000,9999,9999,0.2,30,8000,0
9,0.134,0.019,0.007,0,0,2500,9999,9999,0.2,25,8000,0
10,0.138,0.092,0.23,0,0.092,2000,9999,1500,1,25,8000,0
11,0.069,0.207,0.253,0,0,1500,9999,9999,1,15,8000,0
12,0.184,0.644,0.759,0,0,1500,9999,9999,2.3,20,8000,0
13,0.322,1.058,1.288,0,0,1500,9999,9999,3,25,8000,0
101,0.00459,0,0,0.01377,0,2200,2000,9999,0.4,15,8000,1
102,0.00459,0,0,0.04591,0,2000,1800,9999,1,15,8000,1
103,0.00459,0.01837,0,0.06887,0,1500,1300,9999,2,30,8000,1
104,0.01148,0,0,0.08724,0,2000,1800,9999,2,15,8000,1
105,0.01837,0,0,0.11478,0,1800,1600,9999,1.5,40,8000,1
106,0.00459,0,0,0.15611,0,2200,2000,9999,1.5,40,9000,1
107,0.04591,0,0,0.24793,0,2000,1800,9999,3,15,8000,1
108,0.02296,0.04591,0,0.33517,0,1500,1300,9999,4,30,8000,1
109,0.04591,0.04591,0,0.41322,0,1800,1600,9999,5,40,8000,1
121,0.00918,0,0,0.02296,0.02984,2000,1800,1800,0.9,15,8000,1
122,0.02296,0.02296,0,0.02755,0.04591,2000,1800,1800,1.5,15,8000,1
123,0.01377,0.01148,0,0.06657,0.05739,1800,1600,1600,1.8,40,8000,1
124,0.08724,0.01377,0.00459,0.15611,0.32599,1800,1600,1600,2.1,40,8000,1
141,0.01148,0.01148,0,0.00689,0.05969,2000,1800,1600,1,15,8000,1
142,0.06198,0.11019,0.03444,0,0.17677,2000,9999,1600,1,15,8000,0
143,0.02066,0.13774,0,0,0.28466,1600,9999,1400,2.4,40,8000,0
144,0.03903,0.0528,0.00918,0,0.11708,2000,1800,1600,3,30,8000,0
145,0.16529,0.09642,0,0,0.13315,750,9999,1600,6,15,8000,0
146,0.13315,0.06657,0,0,0.06428,750,9999,1600,2,30,8000,0
147,0.1607,0.24334,0.10101,0,0.15611,750,9999,1600,6,15,8000,0
148,0.09412,0.15611,0.03903,0,0.19972,750,9999,1600,3,40,8000,0
149,0.20661,0.11249,0,0.07117,0.3214,750,1800,1500,4.4,40,8000,1
161,0.00918,0.04132,0.06887,0.00918,0.04132,2000,1800,1600,0.6,20,8000,1
162,0.04362,0.08264,0.05739,0,0.00918,2000,9999,1600,1,30,8000,0
163,0.05051,0.00689,0.01148,0.02984,0.05051,1800,1600,1400,1.3,30,8000,1
164,0.20661,0,0,0,0.09183,2300,9999,2000,0.5,12,8000,0
165,0.18365,0.18365,0.13774,0,0.13774,1500,9999,750,1,25,8000,0
181,0.04591,0.10101,0.16529,0,0,2000,9999,9999,0.2,30,8000,0
182,0.06428,0.1056,0.10101,0,0,2000,9999,9999,0.2,25,8000,0
183,0.02296,0.10101,0.12856,0,0,2000,9999,9999,0.3,20,8000,0
184,0.02296,0.06887,0.19284,0,0,2000,9999,9999,0.4,25,8000,0
185,0.0528,0.11478,0.20202,0,0,2000,9999,1600,0.6,25,8000,0
186,0.11019,0.0551,0.0551,0,0,2000,9999,9999,0.3,25,8000,0
187,0.01377,0.06428,0.3719,0,0,2000,9999,9999,0.4,25,8000,0
188,0.2663,0.06428,0.05051,0,0,1800,9999,9999,0.3,35,8000,0
189,0.30533,0.15152,0.19054,0,0,1800,9999,1600,0.6,35,8000,0
201,0.06887,0.13774,0.50505,0,0,2000,9999,9999,1,25,8000,0
202,0.20661,0.19513,0.18365,0,0,2000,9999,9999,1,25,8000,0
203,0.25253,0.12626,0.13774,0,0,2000,9999,9999,1.2,25,8000,0
204,0.24105,0.1607,0.24105,0,0,2000,9999,9999,2.7,25,8000,0
"""
# Loads [t/ha]; surface to volume [1/cm]; depth [cm]; moisture of extinction [%]; heat [kJ/kg].
_PORTUGUESE = """
211,4.64,2.96,1.28,0,1.12,30,30,38,32,26,20968
212,2.67,1.28,0.69,0,1.17,34,43,38,14.94,25,20469
213,6.5,1.5,0,0,0,43,43,43,10.06,45,20469
214,3.74,2,1.01,0,1.19,53,38,34,4.88,28,20469
221,4.55,1.86,0.61,0,9.08,49,38,38,63.09,28,19969
222,5.65,1.5,0.47,0,7.89,38,38,43,49.99,27,20469
223,8.36,3.81,0,0,4.51,36,30,38,64.01,32,20968
224,1.37,2.89,1.59,0,1.84,34,30,38,39.93,26,20968
225,4.51,1.5,0.49,2.35,0.47,49,68,34,29.87,34,19469
226,2.71,1.01,0,0.65,0.09,43,68,34,10.06,28,20469
227,7.22,3,0,0,6.88,43,43,49,49.99,40,20469
231,3,0.09,0,0,0.29,28,49,28,60.05,23,18970
232,1.5,0,0,0,0,49,49,49,35.05,23,18970
233,9.5,2.51,0,0,14.5,24,28,28,104.85,34,20968
234,6.01,0.49,0,0,7.51,34,34,34,49.99,34,20968
235,2.51,1.01,0,0,5.49,34,74,28,54.86,25,19469
236,6.01,3.99,0,0,13,13,18,18,170.08,35,20469
237,3.99,0.49,0,0,6.99,18,18,18,89.92,35,20469
"""


def models():
    """{code: keyword arguments of `rate`}."""
    found = {}
    for line in _AMERICAN.split("\n"):
        if line:
            code, *numbers, cures = line.split(",")
            loads, ratios = [float(n) for n in numbers[:5]], [float(n) for n in numbers[5:8]]
            depth, extinction, heat = (float(n) for n in numbers[8:])
            found[int(code)] = {
                "loads": loads,
                "ratios": ratios,
                "depth": depth,
                "extinction": extinction / 100,
                "heat": heat,
                "cures": cures == "1",
            }
    for line in _PORTUGUESE.split("\n"):
        if line:
            code, *numbers = line.split(",")
            values = [float(n) for n in numbers]
            found[int(code)] = {
                "loads": [load * 0.0204816 for load in values[:5]],
                "ratios": [ratio * 30.48 for ratio in values[5:8]],
                "depth": values[8] / 30.48,
                "extinction": values[9] / 100,
                "heat": values[10] * 0.429923,
                "cures": False,
            }
    return found


def rate(*, loads, ratios, depth, extinction, heat, cures, moisture=DRY_SUMMER):
    """Rate of spread on flat calm ground [m/h]."""
    sizes = [ratios[0], 109.0, 30.0, ratios[1], ratios[2]]
    dead = [(loads[i], sizes[i], moisture[i]) for i in range(3)]
    grass = loads[3]
    if cures and grass > 0:
        green = min(max(moisture[3] / 0.9 - 1 / 3, 0.0), 1.0)
        dead.append((grass * (1 - green), sizes[3], moisture[0]))
        grass *= green
    live = [(grass, sizes[3], moisture[3]), (loads[4], sizes[4], moisture[4])]
    parts = [[p for p in category if p[0] > 0 and p[1] > 0] for category in (dead, live)]
    surfaces = [[w * s / _DENSITY for w, s, _ in part] for part in parts]
    sums = [sum(surface) for surface in surfaces]
    within = [[a / total for a in surface] for surface, total in zip(surfaces, sums, strict=True)]
    between = [total / sum(sums) for total in sums]
    ratio = sum(
        f * sum(g * p[1] for g, p in zip(inner, part, strict=True))
        for f, inner, part in zip(between, within, parts, strict=True)
    )
    bed = sum(p[0] for part in parts for p in part) / depth
    packing = bed / _DENSITY
    relative = packing / (3.348 * ratio**-0.8189)
    exponent = 133.0 * ratio**-0.7913
    fastest = ratio**1.5 / (495.0 + 0.0594 * ratio**1.5)
    velocity = fastest * relative**exponent * math.exp(exponent * (1 - relative))
    wet = [sum(g * p[2] for g, p in zip(inner, part, strict=True)) for inner, part in zip(within, parts, strict=True)]
    limits = [extinction, _live_extinction(parts, extinction)]
    power = 0.0
    for inner, part, m, limit in zip(within, parts, wet, limits, strict=True):
        power += _net_load(inner, part) * heat * _damping(m / limit) if part else 0.0
    power *= velocity * min(1.0, 0.174 * _SILICA_FREE**-0.19)
    forward = math.exp((0.792 + 0.681 * ratio**0.5) * (packing + 0.1)) / (192.0 + 0.2595 * ratio)
    sink = bed * sum(
        f * sum(g * math.exp(-138.0 / p[1]) * (250.0 + 1116.0 * p[2]) for g, p in zip(inner, part, strict=True))
        for f, inner, part in zip(between, within, parts, strict=True)
    )
    return power * forward / sink * 0.3048 * 60.0


def _damping(share):
    x = min(share, 1.0)
    return max(0.0, 1.0 - 2.59 * x + 5.11 * x**2 - 3.52 * x**3)


def _net_load(inner, part):
    """Load of a category, each size class weighted by its share of the surface."""
    limits = (1200.0, 192.0, 96.0, 48.0, 16.0)
    group = [sum(size < limit for limit in limits) for _, size, _ in part]
    shares = {g: sum(f for f, other in zip(inner, group, strict=True) if other == g) for g in set(group)}
    return sum(shares[g] * w * (1 - _MINERAL) for g, (w, _, _) in zip(group, part, strict=True))


def _live_extinction(parts, dead_extinction):
    dead, live = parts
    if not live:
        return dead_extinction
    fine_dead = sum(w * math.exp(-138.0 / s) for w, s, _ in dead)
    fine_live = sum(w * math.exp(-500.0 / s) for w, s, _ in live)
    wet = sum(w * m * math.exp(-138.0 / s) for w, s, m in dead) / fine_dead
    return max(2.9 * fine_dead / fine_live * (1 - wet / dead_extinction) - 0.226, dead_extinction)
