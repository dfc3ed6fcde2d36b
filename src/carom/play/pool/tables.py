"""The picture of the empty table that everything is drawn over."""

from __future__ import annotations

from threading import Thread

import pygame

from carom.play.pool.table_art import table_picture

#: How many times as large a table is painted at most.
FINEST = 2


class Table:
    """The picture of the empty table, `times` as large as at first.

    A larger one takes seconds to paint, which is done in the background; meanwhile the small one is enlarged. So is the
    one of twice the size where it is to be larger still: there is nothing fine on a table.
    """

    def __init__(self, times: int = 1) -> None:
        small = table_picture()
        self.picture = pygame.Surface(small.shape[:2], 0, 32)
        pygame.surfarray.blit_array(self.picture, small)
        self.painter: Thread | None = None
        if times > 1:
            self.picture = pygame.transform.smoothscale_by(self.picture, times)
            self.painter = Thread(target=table_picture, args=(FINEST,), daemon=True)
            self.painter.start()

    def draw(self, surface: pygame.Surface) -> None:
        """Draw it over a whole surface."""
        if self.painter is not None and not self.painter.is_alive():
            self.painter = None
            fine = table_picture(FINEST)
            painted = pygame.Surface(fine.shape[:2], 0, 32)
            pygame.surfarray.blit_array(painted, fine)
            self.picture = pygame.transform.smoothscale(painted, self.picture.get_size())
        surface.blit(self.picture, (0, 0))
