// A font file with which Pango lays out text. Pango's and Cairo's types stay in this folder.
#pragma once

#include <memory>
#include <string>

#include <cairo.h>
#include <pango/pango-layout.h>

#include "pipeline/picture/annotation.h"

namespace carom::pipeline {

enum class TextAlign { left, centre, right };

/// Lines of text that are laid out.
class LaidText {
  public:
    explicit LaidText(PangoLayout* layout);  // takes it over
    ~LaidText();
    LaidText(LaidText&&) noexcept;
    LaidText& operator=(LaidText&&) noexcept;
    LaidText(const LaidText&) = delete;
    LaidText& operator=(const LaidText&) = delete;

    /// Width of the longest line and height of all lines, pixels.
    [[nodiscard]] Vec2 size() const;

    /// Adds the letters' outlines to the path, with the upper left corner of all lines at `corner`.
    void add_outlines(cairo_t* context, const Vec2& corner) const;

  private:
    PangoLayout* layout_;
};

/// For one thread at a time. Only the file's own glyphs are used, so that the same text has the
/// same outlines whatever fonts and settings a machine has.
class Font {
  public:
    /// Throws Error if the file cannot be read as a font.
    explicit Font(const std::string& file);
    ~Font();
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;

    /// `line_height` in pixels: a letter's em is 0.8 of it.
    [[nodiscard]] LaidText lay_out(const std::string& text, double line_height,
                                   TextAlign align = TextAlign::left) const;

    /// The text with more line ends, between words, so that its lines are at most `width` (pixels)
    /// wide, except for words that are wider.
    [[nodiscard]] std::string wrapped(const std::string& text, double line_height,
                                      double width) const;

  private:
    struct Data;
    [[nodiscard]] PangoLayout* new_layout(const std::string& text, double line_height) const;

    std::unique_ptr<Data> data_;
};

}  // namespace carom::pipeline
