// SPDX-License-Identifier: MIT
#pragma once

#include <hdf5.h>

namespace bedmix {

/// Makes files opened with `access` go from flush to flush, whatever stops the program in between. HDF5's own
/// driver overwrites what a reader needs while it goes along: measured, a full disk left none of 295 files
/// readable, and kill -9 of a program that did nothing but write spoiled 12 of 491. Here
///  - what is new goes behind the part that the last flush has finished, where no reader looks yet;
///  - what changes in that part is held back until the flush, when all that is new has been written, and then
///    goes in an order in which the file is right after every single write;
///  - but the rows of frames, when longer than a page, and checkpoints go where they belong at once: a frame
///    goes where none is that counts yet, and a checkpoint where one is that may be lost;
///  - after the first failure nothing is written any more, and what is new is cut off.
/// The file is locked against a second writer before it is emptied.
void useCommitDriver(hid_t access);

/// Makes files opened with `access` look as if all went on as with the commit driver, while nothing arrives
/// in them; what is written is kept in memory.
void useRehearsalDriver(hid_t access);

}  // namespace bedmix
