"""True airspeeds in the International Standard Atmosphere, up to 20 km."""

import decimal
from decimal import Decimal

from .geography import DIGITS

KNOT = Decimal(1852) / 3600  # m/s
FOOT = Decimal("0.3048")
HIGHEST = 20000  # metres, where the isothermal layer ends

_P0, _RHO0, _T0, _R = Decimal(101325), Decimal("1.225"), Decimal("288.15"), Decimal("287.05287")
_G, _LAPSE, _TROPOPAUSE = Decimal("9.80665"), Decimal("0.0065"), 11000
_GAMMA = Decimal("1.4")


def atmosphere(height: Decimal) -> "tuple[Decimal, Decimal]":
    """Pressure in pascals and temperature in kelvins at a height in metres from -1000 on. Raises ValueError."""
    if not -1000 <= height <= HIGHEST:
        raise ValueError(f"a height that is not from -1000 to {HIGHEST} m")
    with decimal.localcontext(DIGITS):
        temperature = _T0 - _LAPSE * min(height, Decimal(_TROPOPAUSE))
        pressure = _P0 * (temperature / _T0)**(_G / (_LAPSE * _R))
        if height > _TROPOPAUSE:
            pressure *= (-_G * (height - _TROPOPAUSE) / (_R * temperature)).exp()
        return pressure, temperature


def of_mach(mach: Decimal, height: Decimal) -> Decimal:
    """In m/s."""
    with decimal.localcontext(DIGITS):
        return mach * (_GAMMA * _R * atmosphere(height)[1]).sqrt()


def of_calibrated(speed: Decimal, height: Decimal) -> Decimal:
    """In m/s, of a calibrated airspeed in m/s."""
    with decimal.localcontext(DIGITS):
        pressure, temperature = atmosphere(height)
        density = pressure / (_R * temperature)
        impact = _P0 * ((1 + _RHO0 / (7 * _P0) * speed**2)**Decimal("3.5") - 1)
        return (7 * pressure / density * ((1 + impact / pressure)**(Decimal(2) / 7) - 1)).sqrt()
