// pixelscope-plant OUT BUG...: writes one source with all listings that have a bug, for the build. Each BUG is the file
// chapters/FOLDER/bugs/NAME.bug; the listing beside bugs/ gets that bug and the name bug_NAME in place of FOLDER.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "base/read_file.h"
#include "textbook/bug_patch.h"

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: pixelscope-plant OUT BUG...\n", stderr);
    return 2;
  }
  try {
    std::string all = "// Written by pixelscope-plant from chapters/*/bugs/*.bug.\n";
    for (int i = 2; i < argc; ++i) {
      const std::filesystem::path file = argv[i], folder = file.parent_path().parent_path(),
                                  listing = folder / "listing.cpp";
      const ps::BugPatch bug = ps::parse_bug(ps::read_whole_file(file), file.string());
      const std::string text = ps::patch_listing(ps::read_whole_file(listing), bug, file.string()).text;
      const std::string name = folder.filename().string();
      all += fmt::format("#define {} bug_{}\n#line 1 \"{}\"\n{}#undef {}\n", name, file.stem().string(),
                         listing.string(), text, name);
    }
    std::ofstream out(argv[1], std::ios::binary);
    if (!(out << all).flush()) throw std::runtime_error(fmt::format("{}: cannot be written", argv[1]));
  } catch (const std::exception& error) {
    std::fputs(fmt::format("{}\n", error.what()).c_str(), stderr);
    return 1;
  }
}
