#!/usr/bin/env python3
# corpuscle: airbag deployment by the corpuscular method
# SPDX-License-Identifier: MIT
"""Figure of models/tank_test: pressure of its runs against the equations of a mixed tank.

The second and further arguments are runs with heat to the wall: RESULTS.h5=HCONV.
"""

import sys

import h5py
import numpy as np
from results import plt, save

R = 8.314462618                                   # [J/(mol K)]
VOLUME, T_ATM, P_ATM = 60.0e6, 293.0, 1.01325e-4  # [mm3], [K], [GPa]
AREA = 6.0 * VOLUME ** (2.0 / 3.0)                # [mm2]
MOLAR_MASS = 0.0285                               # [kg/mol]
AIR = (29.1, 0.0)                                 # Cp = a + b T [J/(mol K)]
PRODUCTS = (27.0, 0.0056)
FLOW = ((0, 1, 7, 12, 20, 30, 40), (0, 0.5e-3, 1.6e-3, 1.5e-3, 0.9e-3, 0.45e-3, 0.1e-3))
STATIC = ((0, 1, 7, 12, 20, 30, 40), (700, 750, 800, 800, 720, 640, 600))
MOLES_OF_AIR = P_ATM * VOLUME / (R * T_ATM)


def energy(gas, T):
    return (gas[0] - R) * T + 0.5 * gas[1] * T * T


def temperature(U, moles):
    T = 300.0
    for _ in range(20):
        slope = MOLES_OF_AIR * (AIR[0] - R) + moles * (PRODUCTS[0] - R + PRODUCTS[1] * T)
        T -= (MOLES_OF_AIR * energy(AIR, T) + moles * energy(PRODUCTS, T) - U) / slope
    return T


def mixed_tank(time, hconv):
    """Pressure and temperature at the times, midpoint rule."""
    def rate(t, U, moles):
        n = np.interp(t, *FLOW) / MOLAR_MASS if t < 40.0 else 0.0
        hot = np.interp(t, *STATIC)
        return n * (energy(PRODUCTS, hot) + R * hot) - hconv * AREA * (temperature(U, moles) - T_ATM), n

    U, moles, now, rows = MOLES_OF_AIR * energy(AIR, T_ATM), 0.0, 0.0, []
    for t in time:
        dt = (t - now) / 20
        for _ in range(20):
            dU, dn = rate(now, U, moles)
            dU, dn = rate(now + 0.5 * dt, U + 0.5 * dt * dU, moles + 0.5 * dt * dn)
            U, moles, now = U + dt * dU, moles + dt * dn, now + dt
        T = temperature(U, moles)
        rows.append(((MOLES_OF_AIR + moles) * R * T / VOLUME, T))
    return np.array(rows).T


def main():
    if len(sys.argv) < 2:
        sys.exit("usage: tank_test.py RESULTS.h5 [RESULTS.h5=HCONV ...]")
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.6))
    for name in sys.argv[1:]:
        file, _, hconv = name.partition("=")
        run = h5py.File(file, "r")
        bag, time = run["history/airbag/1"], run["history/time"][:]
        p, T = mixed_tank(time, float(hconv or 0.0))
        label = f"{float(hconv) * 1e9:g} W/(m² K)" if hconv else "adiabatic"
        left.plot(time, bag["pressure"][:] * 1e6, linewidth=0.8, label=f"particles, {label}")
        left.plot(time, p * 1e6, "k--", linewidth=0.9)
        for values, exact, what in ((bag["pressure"][:], p, "pressure"), (bag["temperature"][:], T, "temperature")):
            error = (values / exact - 1) * 100
            right.plot(time, error, linewidth=0.8, label=f"{what}, {label}")
            print(f"{label}: {what} is off by {abs(error).max():.3f} % at worst, {error[time > 45].mean():+.3f} % after 45 ms")
    left.set(xlabel="time [ms]", ylabel="pressure [kPa]", title="tank_test; dashed: mixed tank")
    right.set(xlabel="time [ms]", ylabel="against the equations [%]",
              title=f"{int(bag['particles'][:].max())} particles")
    left.legend()
    right.legend()
    save(figure, "tank_test", "tank_test.png")


if __name__ == "__main__":
    main()
