"""Arguments to arrays: what is accepted, and messages for what is not."""

from __future__ import annotations

import operator
from typing import Any, List, Sequence, Tuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
Shape = Tuple[int, ...]


def numbers(name: str, value: Any, is_complex: bool = False) -> Array:
    """The real numbers of an argument as an array, which shares memory where it can.

    With `is_complex` they may be complex: the last dimension holds real and imaginary parts.
    """
    if value is None:
        raise TypeError(f"`{name}` is None: expected an array of real numbers")
    try:
        array = np.asarray(value)
    except (ValueError, TypeError) as error:
        raise ValueError(f"`{name}` is no array of real numbers: {error}") from None
    if is_complex and array.dtype.kind == "c":
        return np.stack([array.real, array.imag], axis=-1).astype(np.float64)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"`{name}` has elements of type {array.dtype}: expected real numbers")
    if array.dtype == np.float64:
        return array
    with np.errstate(over="ignore"):
        return array.astype(np.float64)


def whole(name: str, value: Any) -> int:
    """A number of 64 bits without a sign."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"`{name}` is a {type(value).__name__}: expected a whole number") from None
    if not 0 <= number < 2**63:
        raise ValueError(f"`{name}` is {number}: expected a whole number from 0 to 2**63 - 1")
    return number


def data(
    parameters: Sequence[Tuple[str, Shape]],
    homogeneous: Sequence[str],
    values: Sequence[Any],
    complex_numbers: Sequence[str] = (),
) -> Tuple[List[Array], int]:
    """The data of a batch as contiguous arrays, and the number of instances.

    The number is -1 where every array has the shape of one instance. An array of that shape in a
    batch holds for all instances.
    """
    if len(values) != len(parameters):
        names = ", ".join(name for name, _ in parameters)
        raise TypeError(f"expected {len(parameters)} arrays ({names}), got {len(values)}")
    arrays: List[Array] = []
    count = -1
    for (name, shape), value in zip(parameters, values):
        array = numbers(name, value, name in complex_numbers)
        if name in homogeneous:
            array = with_ones(array, shape)
        count = joined(name, shape, array.shape, count)
        if not (array.flags.c_contiguous and array.flags.aligned):
            array = array.copy()
        arrays.append(array)
    return arrays, count


def with_ones(array: Array, shape: Shape) -> Array:
    """Image points as rays: with a third coordinate 1."""
    if array.ndim in (len(shape), len(shape) + 1) and array.shape[-1] == 2:
        return np.concatenate([array, np.ones((*array.shape[:-1], 1))], axis=-1)
    return array


def joined(name: str, expected: Shape, found: Shape, count: int) -> int:
    """The number of instances, with another array."""
    if found == expected:
        return count
    if found[1:] != expected or len(found) != len(expected) + 1:
        batch = "(n, " + ", ".join(map(str, expected)) + ")" if expected else "(n,)"
        raise ValueError(f"`{name}` has the shape {found}: expected {expected}, or {batch} for n instances")
    if count not in (-1, found[0]):
        raise ValueError(f"`{name}` holds {found[0]} instances, the arrays before it {count}")
    return found[0]
