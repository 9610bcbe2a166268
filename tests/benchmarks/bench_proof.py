"""Speed of a proof over boxes: the 3-RRR keeps the sign of its determinant, by intervals and bisection."""

import numpy as np
import sympy as sp

from lynx_common import certify, rrr
from lynx_common.symbolic import DESIGN, POSE, enclose


def test_the_proof_that_the_3_rrr_keeps_its_sign_at_most_a_second(benchmark):
    corners = [sp.pi / 2, 7 * sp.pi / 6, 11 * sp.pi / 6]
    exact = dict(zip(DESIGN, (*map(sp.Integer, (170, 130, 130, 290)), *corners, *corners), strict=True))
    entries = sp.symbols("a:9")
    u, v, w = (sp.Matrix(3, 3, entries)[i, :] for i in range(3))
    rows, det = (
        enclose(rrr.formulas.unit_rows((1, 1, 1)).xreplace(exact), POSE),
        enclose(-u.dot(v.cross(w)), entries),
    )

    def bounds(box):
        return det(np.stack(rows(box), axis=-1).reshape(*box.shape[:-2], 9, 2))

    box = [[-60, 60], [-60, 60], np.deg2rad([-30, 30])]
    proof = benchmark.pedantic(certify.over, [bounds, box], rounds=11, warmup_rounds=1)
    assert proof.verdict == "certified"
    median = benchmark.stats.stats.median
    print(f"\n{len(proof.boxes)} boxes proven in {median * 1e3:.0f} ms: {proof.evaluations / median:.0f} boxes/s")
    assert median <= 1
