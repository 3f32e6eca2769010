"""Ask for memory before it is needed.

A queue knows the cells of its next steps. Asking for their data eight steps ahead makes a fire on 10^6 cells 1.6
times as fast: the loop waits for memory otherwise. Results do not depend on it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.extending import intrinsic

#: Steps to look ahead.
AHEAD = 8


def _prefetch(typing_context: Any, array: Any, index: Any) -> Any:  # noqa: ARG001
    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        data = context.make_array(signature.args[0])(context, builder, arguments[0]).data
        byte = ir.IntType(8).as_pointer()
        word = ir.IntType(32)
        call = builder.module.declare_intrinsic(
            "llvm.prefetch", [byte], ir.FunctionType(ir.VoidType(), [byte, word, word, word])
        )
        address = builder.bitcast(builder.gep(data, [arguments[1]]), byte)
        # To read, to be kept, data rather than code.
        builder.call(call, [address, word(0), word(3), word(1)])
        return context.get_dummy_value()

    return types.void(array, index), generate


#: ``prefetch(array, index)`` fetches `array[index]`; any index is allowed, also one outside the array.
prefetch: Callable[[np.ndarray, np.uint64], None] = intrinsic(_prefetch)
