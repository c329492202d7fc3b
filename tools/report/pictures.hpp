// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace corpuscle::report {

/// A picture as a file: "strip.png" and its bytes.
struct PictureFile {
    std::string name, bytes;
};

/// Up to eight frames of a page's first run, picture_00.png and so on, and all of them in
/// strip.png, as a headless Chromium on the PATH draws them.
/// @throws SystemError if there is no Chromium, or if it cannot draw the page
[[nodiscard]] std::vector<PictureFile> pictures(std::string page);

/// Name of the Chromium on the PATH; empty: there is none.
[[nodiscard]] std::string browser();

}  // namespace corpuscle::report
