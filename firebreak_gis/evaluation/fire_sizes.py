"""The sizes of many fires: how simulated ones grow, how long real ones lasted, and the durations that make both agree.

If all rates of spread are c times as high, a fire is at time t what it was at time c t. So one simulation of long fires
tells the sizes under every rate and every distribution of durations, without any further run. With durations D whose
logarithm is normal (median m, standard deviation s), the share of the fires of run i that stay within the size x is

    P(size <= x) = Phi((ln T_i(x) - ln(c m)) / s),

T_i(x) being the time at which the run reaches x; the distribution of sizes is its mean over the runs. Sizes alone tell
only the product c m; c is told by fires of which the days are known as well.

The idea of fitting the durations to the sizes of historical fires is that of MTTfireCAL (Aparicio et al. 2023, doi
10.3390/fire6060219), which weighs a few classes of duration; two parameters are fewer than the weights of five classes.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from firebreak_gis.errors import InputError, ParameterError

#: Bootstrap samples of an interval.
_RESAMPLES = 2000
#: Narrowest and widest distribution of durations that a fit may find: standard deviations of the logarithm.
_SIGMA = (0.05, 4.0)


class Growth(NamedTuple):
    """How large each simulated fire is by each time.

    Parameters
    ----------
    times
        (n_times,) seconds, rising, above 0.
    hectares
        (n_runs, n_times) area burnt by then, not falling.
    """

    times: np.ndarray
    hectares: np.ndarray

    def at(self, seconds: np.ndarray) -> np.ndarray:
        """Size of each run at its own time, (n_runs,) ha; by straight lines in the logarithms, ends extended flat."""
        clock = np.log(np.clip(np.asarray(seconds, dtype=np.float64), self.times[0], self.times[-1]))
        nodes = np.log(self.times)
        right = np.clip(np.searchsorted(nodes, clock, side="left"), 1, nodes.size - 1)
        runs = np.arange(self.hectares.shape[0])
        share = (clock - nodes[right - 1]) / (nodes[right] - nodes[right - 1])
        sizes = np.log(self.hectares)
        return np.asarray(np.exp((1.0 - share) * sizes[runs, right - 1] + share * sizes[runs, right]))

    def until(self, seconds: float) -> Growth:
        """Return the growth up to a time, at which all fires end."""
        times = np.append(self.times[self.times < seconds], min(seconds, self.times[-1]))
        runs = self.hectares.shape[0]
        return Growth(times, np.column_stack([self.at(np.full(runs, time)) for time in times]))

    def log_time_of(self, sizes: np.ndarray) -> np.ndarray:
        """Logarithm of the time at which each run grows beyond each size, (n_runs, n_sizes); inf if it never does.

        A size below that of the first time is passed at once: -inf.
        """
        nodes, grown = np.log(self.times), np.log(self.hectares)
        wanted = np.log(np.asarray(sizes, dtype=np.float64))
        out = np.empty((grown.shape[0], wanted.size))
        for run, line in enumerate(grown):
            right = np.searchsorted(line, wanted, side="right")  # the first time at which it is larger
            inner = np.clip(right, 1, line.size - 1)
            step = line[inner] - line[inner - 1]
            share = np.where(step > 0, (wanted - line[inner - 1]) / np.where(step > 0, step, 1.0), 0.0)
            out[run] = nodes[inner - 1] + share * (nodes[inner] - nodes[inner - 1])
            out[run, right == 0] = -np.inf
            out[run, right == line.size] = np.inf
        return out


class Durations(NamedTuple):
    """Durations of fires: the logarithm is normal.

    Parameters
    ----------
    median
        Seconds, of fires that spread at the simulated rates.
    sigma
        Standard deviation of the logarithm.
    """

    median: float
    sigma: float


def share_within(growth: Growth, sizes: np.ndarray, durations: Durations) -> np.ndarray:
    """Share of the fires that stay within each size, (n_sizes,)."""
    return _mean_normal(growth.log_time_of(sizes), durations)


def sample_sizes(growth: Growth, durations: Durations, *, seed: int = 0, draws: int = 1000) -> np.ndarray:
    """Sizes of fires with drawn durations, (draws x n_runs,) ha; each run gets durations from all the distribution.

    Few of the many fires are large, so that it takes a thousand draws a run to tell their sizes.
    """
    from scipy.special import ndtri

    n_runs = growth.hectares.shape[0]
    shift = np.random.default_rng(seed).random(n_runs)
    sizes = [
        growth.at(durations.median * np.exp(durations.sigma * ndtri((draw + shift) / draws))) for draw in range(draws)
    ]
    return np.concatenate(sizes)


def fit_durations(growth: Growth, observed: np.ndarray, *, least: float, near: Durations | None = None) -> Durations:
    """Find the durations under which the simulated sizes are distributed like the observed ones.

    Parameters
    ----------
    growth
        Of a simulation whose fires start as the real ones do.
    observed
        (n_fires,) ha. Only those of at least `least` count, as small fires are often not mapped or put out at once; the
        simulated ones are judged on the same terms, given that they reach `least`.
    least
        Smallest size that counts [ha].

    Returns
    -------
    Durations
        Those with the least Anderson-Darling distance (Anderson, Darling 1954, doi 10.1080/01621459.1954.10501232),
        which minds the few largest fires as much as the many others.

    Raises
    ------
    ParameterError
        If fewer fires count than parameters are fitted (2).
    InputError
        If no simulated fire grows to the size of the observed ones.
    """
    from scipy import optimize

    sizes = np.sort(np.asarray(observed, dtype=np.float64)[np.asarray(observed) >= least])
    if sizes.size < 2:
        raise ParameterError(
            f"{sizes.size} fires of at least {least:g} ha cannot tell 2 parameters (median and spread of the "
            "durations); give more fires or take a smaller --least"
        )
    times = growth.log_time_of(np.concatenate([[least], sizes]))
    reachable = np.isfinite(times[:, 1:]).any(axis=0)
    if not reachable.any():
        raise InputError(
            f"no simulated fire grows to {sizes[0]:g} ha within {growth.times[-1] / 3600:g} h; simulate longer ones, "
            "or check rates of spread and spread probabilities"
        )

    def apart(guess: np.ndarray) -> float:
        low, high = _SIGMA
        if not low <= guess[1] <= high:
            return 1e6 * (1.0 + abs(float(guess[1]) - min(max(float(guess[1]), low), high)))
        return _anderson_darling(_conditional(times, Durations(math.exp(guess[0]), float(guess[1]))))

    if near is None:
        finite = times[np.isfinite(times)]
        middles = np.linspace(finite.min() - 2.0, finite.max() + 1.0, 15)
        guesses = [np.array([middle, sigma]) for middle in middles for sigma in (0.3, 0.7, 1.2, 2.0, 3.0)]
        best = min(guesses, key=apart)
    else:
        best = np.array([math.log(near.median), near.sigma])
    found = optimize.minimize(apart, best, method="Nelder-Mead", options={"xatol": 1e-4, "fatol": 1e-7, "maxiter": 400})
    return Durations(float(math.exp(found.x[0])), float(found.x[1]))


def distance(growth: Growth, durations: Durations, observed: np.ndarray, *, least: float) -> float:
    """Anderson-Darling distance of observed sizes of at least `least` ha from the simulated ones; less is better."""
    sizes = np.sort(np.asarray(observed, dtype=np.float64)[np.asarray(observed) >= least])
    return _anderson_darling(_conditional(growth.log_time_of(np.concatenate([[least], sizes])), durations))


def leave_one_out(growth: Growth, observed: np.ndarray, *, least: float) -> np.ndarray:
    """Where each fire lies in the distribution that is fitted without it.

    Returns
    -------
    numpy.ndarray
        (n_fires,) share of the simulated fires that are smaller, nan for fires below `least`. Even numbers from 0 to 1
        mean that the fit foretells fires that it has not seen.

    Raises
    ------
    ParameterError, InputError
        As `fit_durations`.
    """
    sizes = np.asarray(observed, dtype=np.float64)
    out = np.full(sizes.size, np.nan)
    everything = fit_durations(growth, sizes, least=least)
    for i in np.flatnonzero(sizes >= least):
        durations = fit_durations(growth, np.delete(sizes, i), least=least, near=everything)
        out[i] = _conditional(growth.log_time_of(np.array([least, sizes[i]])), durations)[0]
    return out


def rate_factor(growth: Growth, hectares: np.ndarray, seconds: np.ndarray) -> float:
    """Find how many times as fast fires spread as simulated.

    Parameters
    ----------
    growth
        Of the simulation.
    hectares, seconds
        (n_fires,) sizes, and how long the fires spread.

    Returns
    -------
    float
        The median over the fires of T(x) / seconds, T(x) being the median time at which simulated fires that reach the
        size x do so: half of the fires are faster, half slower.

    Raises
    ------
    ParameterError
        If there is no fire.
    InputError
        If no simulated fire reaches the sizes.
    """
    sizes, spread = np.asarray(hectares, dtype=np.float64), np.asarray(seconds, dtype=np.float64)
    if sizes.size < 1:
        raise ParameterError("no fire has both a size and a duration, so nothing tells the rate of spread")
    times = growth.log_time_of(sizes)
    reached = np.where(np.isfinite(times), times, np.nan)
    kept = np.isfinite(reached).any(axis=0)
    if not kept.any():
        raise InputError("no simulated fire reaches the sizes of the observed ones; simulate longer ones")
    return float(np.exp(np.median(np.nanmedian(reached[:, kept], axis=0) - np.log(spread[kept]))))


def statistics(hectares: np.ndarray, *, least: float, large: float) -> dict[str, float]:
    """Median and 90 % percentile of the fires of at least `least` ha, and the share of all area in those of `large`."""
    sizes = np.asarray(hectares, dtype=np.float64)
    counted, total = sizes[sizes >= least], sizes.sum()
    return {
        "median_ha": float(np.median(counted)) if counted.size else math.nan,
        "p90_ha": float(np.percentile(counted, 90)) if counted.size else math.nan,
        "large_share": float(sizes[sizes >= large].sum() / total) if total else math.nan,
    }


def bootstrap(hectares: np.ndarray, *, least: float, large: float, seed: int = 0) -> dict[str, tuple[float, float]]:
    """90 % intervals of `statistics` by resampling all fires (percentiles 5 and 95)."""
    sizes = np.asarray(hectares, dtype=np.float64)
    if not (sizes >= least).any():
        raise InputError(f"no fire has {least:g} ha or more")
    random = np.random.default_rng(seed)
    picks = [random.integers(0, sizes.size, sizes.size) for _ in range(_RESAMPLES)]
    samples = [statistics(sizes[pick], least=least, large=large) for pick in picks]
    ends = {name: np.nanpercentile([sample[name] for sample in samples], (5, 95)) for name in samples[0]}
    return {name: (float(low), float(high)) for name, (low, high) in ends.items()}


def _mean_normal(log_times: np.ndarray, durations: Durations) -> np.ndarray:
    from scipy.special import ndtr

    return np.asarray(ndtr((log_times - math.log(durations.median)) / durations.sigma).mean(axis=0))


def _conditional(log_times: np.ndarray, durations: Durations) -> np.ndarray:
    """Share of the fires beyond the first size that stay within each of the others."""
    shares = _mean_normal(log_times, durations)
    beyond = max(1.0 - shares[0], 1e-12)
    return np.asarray(np.clip((shares[1:] - shares[0]) / beyond, 0.0, 1.0))


def _anderson_darling(shares: np.ndarray) -> float:
    """Distance of the shares of rising sizes from even ones."""
    n = shares.size
    inside = np.clip(shares, 1e-6, 1.0 - 1e-6)
    weights = 2.0 * np.arange(1, n + 1) - 1.0
    return float(-n - (weights * (np.log(inside) + np.log1p(-inside[::-1]))).sum() / n)
