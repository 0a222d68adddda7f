"""What solvers return."""

from __future__ import annotations

import math
from enum import IntEnum
from functools import lru_cache
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from . import _eliminant
from ._arrays import Array, Shape

if TYPE_CHECKING:
    from typing import Type

Named = Tuple[Tuple[str, Shape], ...]

Status = IntEnum("Status", _eliminant.STATUS)  # type: ignore[misc]
Status.__doc__ = "What came of an instance of a batch: `SOLVED`, or the kind of its error."


class Solutions:
    """The solutions of one instance, or of a batch of instances.

    ``values`` holds the unknowns, one solution a row: of shape (k, unknowns) for one instance with
    k real solutions, of shape (n, most, unknowns) for n instances, filled up with NaN. Unknowns and
    results are attributes by their names, too, of shapes (k, ...) and (n, most, ...), and
    ``solutions["name"]`` gives the same, also where the name is that of an attribute.
    ``numpy.asarray(solutions)`` is ``values``.
    """

    __slots__ = ("_arrays", "_codes", "counts", "unknowns", "values")

    values: Array
    """The unknowns."""
    counts: npt.NDArray[np.int64]
    """The number of solutions: of shape () for one instance, (n,) for a batch."""
    unknowns: Tuple[str, ...]
    """The names of the scalars in a row of `values`."""

    def __init__(
        self,
        arrays: Dict[str, npt.NDArray[Any]],
        values: Array,
        counts: npt.NDArray[np.int64],
        codes: npt.NDArray[np.uint16],
        unknowns: Tuple[str, ...],
    ) -> None:
        self._arrays = arrays
        self._codes = codes
        self.values = values
        self.counts = counts
        self.unknowns = unknowns

    @property
    def is_batch(self) -> bool:
        """Whether these are the solutions of a batch."""
        return self.counts.ndim == 1

    @property
    def names(self) -> Tuple[str, ...]:
        """The names of all arrays: the unknowns, then the results of the problem."""
        return tuple(self._arrays)

    @property
    def status(self) -> npt.NDArray[np.uint8]:
        """What came of each instance, as numbers of `Status`."""
        return (self._codes & 0xFF).astype(np.uint8)

    def error(self, instance: int) -> Optional[str]:
        """Why an instance of a batch has no solutions; None where it was solved."""
        return _eliminant.status_text(int(self._codes[instance])) or None

    @property
    def errors(self) -> Dict[int, str]:
        """The text of the error of each instance that has one."""
        return {int(at): _eliminant.status_text(int(self._codes[at])) for at in np.flatnonzero(self._codes)}

    def __getattr__(self, name: str) -> Array:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self._arrays[name]
        except KeyError:
            names = ", ".join(self.names)
            raise AttributeError(f"no unknown or result `{name}`: there are {names}") from None

    def __getitem__(self, key: Any) -> Any:
        """An array by its name, or part of `values`."""
        return self._arrays[key] if isinstance(key, str) else self.values[key]

    def __dir__(self) -> List[str]:
        return [*super().__dir__(), *self._arrays]

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> npt.NDArray[Any]:
        if copy:
            return np.array(self.values, dtype=dtype)
        return np.asarray(self.values, dtype=dtype)

    @property
    def shape(self) -> Shape:
        """The shape of `values`."""
        return self.values.shape

    def __len__(self) -> int:
        """The number of solutions of one instance, or of instances of a batch."""
        return len(self.values)

    def __iter__(self) -> Iterator[Array]:
        return iter(self.values)

    def of(self, instance: int) -> "Solutions":
        """The solutions of one instance of a batch, without the NaN.

        Raises `SolveError` where the instance has an error.
        """
        if not self.is_batch:
            raise TypeError("these are the solutions of one instance")
        error = self.error(instance)
        if error is not None:
            raise _eliminant.SolveError(error)
        count = int(self.counts[instance])
        arrays = {name: array[instance, :count] for name, array in self._arrays.items()}
        values = self.values[instance, :count]
        return Solutions(
            arrays, values, self.counts[instance : instance + 1].reshape(()), self._codes[:0], self.unknowns
        )

    def with_complex(self, names: Sequence[str]) -> "Solutions":
        """With these arrays, whose last dimension holds real and imaginary parts, as complex ones."""
        arrays = dict(self._arrays)
        for name in arrays.keys() & set(names):
            arrays[name] = arrays[name][..., 0] + 1j * arrays[name][..., 1]
        return Solutions(arrays, self.values, self.counts, self._codes, self.unknowns)

    def __repr__(self) -> str:
        names = ", ".join(f"{name} {array.shape}" for name, array in self._arrays.items())
        if not self.is_batch:
            return f"<{len(self)} solutions: {names}>"
        failed = int(np.count_nonzero(self._codes))
        return (
            f"<{int(self.counts.sum())} solutions of {len(self)} instances, {failed} with an error: {names}>"
        )

    def __reduce__(self) -> "Tuple[Type[Solutions], Tuple[Any, ...]]":
        return Solutions, (self._arrays, self.values, self.counts, self._codes, self.unknowns)


@lru_cache(maxsize=256)
def element_names(fields: Named) -> Tuple[str, ...]:
    """The scalars of arrays as problem files name them: `x`, or `v[0]`, `v[1]`."""
    names = []
    for name, shape in fields:
        names += [name + "".join(f"[{at}]" for at in index) for index in np.ndindex(*shape)]
    return tuple(names)


def arranged(
    fields: Named,
    results: Named,
    most: int,
    solved: Tuple[Array, Array, npt.NDArray[np.int64], npt.NDArray[np.uint16]],
    is_batch: bool,
    names: Optional[Tuple[str, ...]] = None,
) -> Solutions:
    """The flat lists of a solve as arrays with names."""
    unknowns, others, counts, codes = solved
    names = names or element_names(fields)
    lead: Shape = (len(counts), most)
    values = unknowns.reshape(*lead, len(names))
    if not is_batch:
        # Without the NaN.
        lead = (int(counts[0]),)
        values, counts, codes = values[0, : lead[0]], counts.reshape(()), codes[:0]
    arrays = split(fields, values)
    width = sum(size_of(shape) for _, shape in results)
    if width:
        arrays.update(split(results, others.reshape(-1, width)[: size_of(lead)].reshape(*lead, width)))
    return Solutions(arrays, values, counts, codes, names)


def split(named: Named, values: Array) -> Dict[str, Array]:
    """The arrays whose scalars stand side by side in the last dimension."""
    arrays: Dict[str, Array] = {}
    at = 0
    for name, shape in named:
        size = size_of(shape)
        arrays[name] = values[..., at : at + size].reshape(*values.shape[:-1], *shape)
        at += size
    return arrays


def size_of(shape: Shape) -> int:
    """The number of elements of an array."""
    return math.prod(shape)
