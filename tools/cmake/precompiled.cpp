// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT

// Nothing of its own: precompiled headers belong to a target, and a target has a source.
