#pragma once
#include <filesystem>
#include <string>
#include <string_view>

/// Where the files that Pixelscope ships with lie. No other file joins such paths, so that another home for them (a
/// package, a browser's file system) is a change here alone. The folders are those of the source tree it was built
/// from, unless the environment variable PIXELSCOPE_ROOT names another folder with assets/ and chapters/ in it.

namespace ps {

std::filesystem::path asset_dir();
/// The built-in scenes: one folder for each source, a .scene file for each scene.
std::filesystem::path scene_dir();

/// One folder for each lesson.
std::filesystem::path chapter_dir();
/// The order of the lessons.
std::filesystem::path course_file();
/// The terms of the lessons and what they mean.
std::filesystem::path glossary_file();
/// The text of the lesson in this folder of chapter_dir(), and its listing; either may be missing.
std::filesystem::path lesson_file(std::string_view folder);
std::filesystem::path listing_file(std::string_view folder);
/// The file of a bug of that listing ("missing_lines").
std::filesystem::path listing_bug_file(std::string_view folder, std::string_view bug);

/// The name of a file as it is written for other machines: below chapter_dir() it is its place in the project
/// ("chapters/NAME/FILE.scene"); any other name stays as it is.
std::string portable_name(const std::string& name);
/// The reverse: the file's name on this machine. A text that names no file below chapter_dir() stays as it is.
std::string local_name(std::string_view text);

/// A shader of the hardware renderer ("fragment.glsl").
std::filesystem::path shader_file(std::string_view name);

/// The folder below which a student's own listing finds textbook/listing.h, the library that makes a program of it, and
/// the program that starts others with limits (app/launch). The last two lie in the build folder.
std::filesystem::path header_dir();
std::filesystem::path listing_library();
std::filesystem::path launcher_program();

/// A font copied beside the programs ("Inter-Regular.otf"); it may be missing.
std::filesystem::path font_file(std::string_view name);

}  // namespace ps
