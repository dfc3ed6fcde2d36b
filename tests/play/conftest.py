"""What all tests of games need: no screen, no sound card, and whether screens are kept anew."""

from collections.abc import Iterator

import pytest

pygame = pytest.importorskip("pygame", reason='no pygame: pip install "carom[play]"')


@pytest.fixture(autouse=True)
def blind(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """SDL without a screen, as large as they are, and without a sound card, closed again after each test."""
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    monkeypatch.setenv("SDL_AUDIODRIVER", "dummy")
    monkeypatch.setattr(pygame.display, "get_desktop_sizes", lambda: [(1920, 1080)])
    yield
    pygame.quit()


@pytest.fixture
def renew(request: pytest.FixtureRequest) -> bool:
    """Whether screens are to be kept anew."""
    return bool(request.config.getoption("--renew-pictures"))
