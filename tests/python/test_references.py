# SPDX-License-Identifier: GPL-2.0-or-later
"""For every law there are tests with reference values that do not come from the package."""

import pytest
from references import count


@pytest.fixture(scope="module")
def found():
    return count.found(count.ROOT)


@pytest.mark.parametrize("law", count.LAWS)
def test_no_law_has_fewer(law, found):
    before, _ = count.LAWS[law]
    assert len(found[law]) >= max(before, 1), found[law]
