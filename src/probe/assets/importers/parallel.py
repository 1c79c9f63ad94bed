"""Work over many objects in processes whose time and memory are limited."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context
from typing import TypeVar

from probe.assets.importers.limits import set_limits

Job = TypeVar("Job")
Result = TypeVar("Result")


def spread(
    work: Callable[[Job], Result], jobs: Sequence[Job], workers: int
) -> Iterator[tuple[Job, Result | None]]:
    """Do jobs in worker processes; yields each with its result as it is known.

    Args:
        work: A function of a module; what it raises is raised here and ends the work.
        jobs: Values that can be sent to another process.
        workers: How many at once.

    Yields:
        Job and result; None for jobs that were lost because a worker was killed.
    """
    if not jobs:
        return
    spawn = get_context("spawn")
    with ProcessPoolExecutor(workers, mp_context=spawn, initializer=set_limits) as pool:
        waiting: dict[Future[Result], Job] = {pool.submit(work, job): job for job in jobs}
        try:
            for future in as_completed(waiting):
                yield waiting[future], _result(future)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise


def _result(future: Future[Result]) -> Result | None:
    try:
        return future.result()
    except BrokenProcessPool:
        return None
