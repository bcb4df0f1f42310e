# SPDX-License-Identifier: GPL-2.0-or-later
"""No law loses the references that do not come from the package."""

import pytest
from references import count

FOUND = count.found(count.ROOT)


@pytest.mark.parametrize("law", count.LAWS)
def test_no_law_has_fewer(law):
    before, _ = count.LAWS[law]
    assert len(FOUND[law]) >= max(before, 1), FOUND[law]
