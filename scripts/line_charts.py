"""Line charts as SVG for the documentation: panels side by side, readable in light and in dark. No package is needed."""

import html
import math

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")  # as in carom's own drawings
DASHES = {"solid": "", "dashed": "7 4", "dotted": "1.5 4", "long": "14 4"}
INK = {"paper": ("#ffffff", "#15181b"), "ink": ("#1c1f22", "#e9ecee"), "faint": ("#70777d", "#9aa3ab")}
WIDTH = 900  # of the drawing, in units of the text's size / 12
GAP = 58  # left of each panel, for its numbers and label


class Line:
    """Points (x, y) of one name. kind: a dash, or `dots`, or `band` (x, y low, y high)."""

    def __init__(self, name, points, colour, kind="solid"):
        self.name, self.points, self.colour, self.kind = name, points, colour, kind


class Panel:
    """One pair of axes: title, labels with units, ranges (low, high) and the steps of the grid."""

    def __init__(self, title, across, up, x_range, y_range, x_step, y_step, lines):
        self.title, self.across, self.up = title, across, up
        self.x_range, self.y_range, self.x_step, self.y_step = x_range, y_range, x_step, y_step
        self.lines = lines


def style():
    def page(which):
        paper, ink, faint = (INK[name][which] for name in ("paper", "ink", "faint"))
        return (f".paper{{fill:{paper}}}text{{fill:{ink}}}text.faint{{fill:{faint}}}.axis{{stroke:{ink}}}"
                f".grid{{stroke:{faint}}}.inkline{{stroke:{ink}}}.inkfill{{fill:{ink}}}"
                f".dot{{stroke:{paper}}}.band{{fill:{faint}}}")

    return ("text{font-family:\"DejaVu Sans\",Verdana,sans-serif;font-size:12px}"
            ".title{font-size:17px;font-weight:bold}.head{font-size:13px;font-weight:bold}"
            ".middle{text-anchor:middle}.end{text-anchor:end}"
            ".line{fill:none;stroke-width:2.2;stroke-linejoin:round;stroke-linecap:butt}"
            ".axis{stroke-width:1;fill:none}.grid{stroke-width:.6;stroke-opacity:.4;fill:none}"
            ".dot{stroke-width:1}.band{fill-opacity:.22}"
            + page(0) + f"@media (prefers-color-scheme:dark){{{page(1)}}}@media print{{{page(0)}}}")


def steps(low, high, step):
    first = math.ceil(low / step - 1e-9)
    return [step * count for count in range(first, math.floor(high / step + 1e-9) + 1)]


def short(value, step):
    digits = max(0, -math.floor(math.log10(step) + 1e-9))
    text = f"{value:.{digits}f}"
    return text.replace("-", "\u2212") if float(text) else text.replace("-", "")


def stroke(colour):
    return 'class="line inkline"' if colour == "ink" else f'class="line" stroke="{colour}"'


def fill(colour):
    return 'class="dot inkfill"' if colour == "ink" else f'class="dot" fill="{colour}"'


def clipped(points, low, high):
    """The parts of a line whose y is inside the panel, cut at its borders."""
    parts, part = [], []
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        start, end = 0.0, 1.0
        for limit, sign in ((low, 1), (high, -1)):
            a, b = sign * (y0 - limit), sign * (y1 - limit)
            if a < 0 and b < 0:
                start, end = 1.0, 0.0
            elif a < 0:
                start = max(start, a / (a - b))
            elif b < 0:
                end = min(end, a / (a - b))
        if start >= end:
            parts, part = parts + [part] if part else parts, []
            continue
        ends = [(x0 + t * (x1 - x0), y0 + t * (y1 - y0)) for t in (start, end)]
        if start > 0 and part:
            parts, part = parts + [part], []
        part = part + ends[1:] if part else ends
        if end < 1:
            parts, part = parts + [part], []
    return parts + [part] if part else parts


def draw_line(line, place, y_range):
    if line.kind == "dots":
        return [f'<circle {fill(line.colour)} cx="{x:.1f}" cy="{y:.1f}" r="4.2"/>'
                for x, y in (place(*point) for point in line.points)]
    if line.kind == "band":
        border = [place(x, low) for x, low, _ in line.points] + [place(x, high) for x, _, high in reversed(line.points)]
        return ['<polygon class="band" points="' + " ".join(f"{x:.1f},{y:.1f}" for x, y in border) + '"/>']
    dash = f' stroke-dasharray="{DASHES[line.kind]}"' if DASHES[line.kind] else ""
    return [f'<polyline {stroke(line.colour)}{dash} points="'
            + " ".join(f"{x:.1f},{y:.1f}" for x, y in (place(*point) for point in part)) + '"/>'
            for part in clipped(line.points, *y_range)]


def draw_panel(panel, left, top, width, height):
    (x_low, x_high), (y_low, y_high) = panel.x_range, panel.y_range

    def place(x, y):
        return left + width * (x - x_low) / (x_high - x_low), top + height * (y_high - y) / (y_high - y_low)

    out = [f'<text class="head" x="{left}" y="{top - 10}">{html.escape(panel.title)}</text>']
    for x in steps(x_low, x_high, panel.x_step):
        across = place(x, y_low)[0]
        out.append(f'<path class="grid" d="M{across:.1f} {top}V{top + height}"/>')
        out.append(f'<text class="middle faint" x="{across:.1f}" y="{top + height + 17}">{short(x, panel.x_step)}</text>')
    for y in steps(y_low, y_high, panel.y_step):
        up = place(x_low, y)[1]
        out.append(f'<path class="grid" d="M{left} {up:.1f}H{left + width}"/>')
        out.append(f'<text class="end faint" x="{left - 6}" y="{up + 4:.1f}">{short(y, panel.y_step)}</text>')
    out.append(f'<path class="axis" d="M{left} {top}V{top + height}H{left + width}"/>')
    out.append(f'<text class="middle" x="{left + width / 2}" y="{top + height + 36}">{html.escape(panel.across)}</text>')
    middle = top + height / 2
    out.append(f'<text class="middle" transform="translate({left - 42} {middle}) rotate(-90)">{html.escape(panel.up)}</text>')
    for line in sorted(panel.lines, key=lambda one: ("band", "dots").index(one.kind) * 2 - 1
                       if one.kind in ("band", "dots") else 0):
        out += draw_line(line, place, panel.y_range)
    return out


def legend(entries, top):
    """Rows of (name, colour, kind), and the height that they take."""
    out, left, line = [], 16, 0
    for name, colour, kind in entries:
        width = 44 + 7.3 * len(name) + 18
        if left > 16 and left + width > WIDTH - 10:
            left, line = 16, line + 1
        y = top + 20 * line
        if kind == "dots":
            out.append(f'<circle {fill(colour)} cx="{left + 18}" cy="{y - 4}" r="4.2"/>')
        elif kind == "band":
            out.append(f'<rect class="band" x="{left}" y="{y - 10}" width="36" height="12"/>')
        else:
            dash = f' stroke-dasharray="{DASHES[kind]}"' if DASHES[kind] else ""
            out.append(f'<path {stroke(colour)}{dash} d="M{left} {y - 4}h36"/>')
        out.append(f'<text x="{left + 44}" y="{y}">{html.escape(name)}</text>')
        left += width
    return out, 20 * (line + 1)


def chart(title, rows, entries, height=250):
    """A document with rows of panels; entries: the legend's (name, colour, kind)."""
    keys, key_height = legend(entries, 54)
    top, body = 54 + key_height + 20, []
    for row in rows:
        width = (WIDTH - 12) / len(row) - GAP - 10
        for count, panel in enumerate(row):
            body += draw_panel(panel, round(GAP + count * (width + GAP + 10), 1), top, round(width, 1), height)
        top += height + 72
    full = top - 16
    return "\n".join([
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{full}" viewBox="0 0 {WIDTH} {full}">',
        f"<title>{html.escape(title)}</title>", f"<style>{html.escape(style(), quote=False)}</style>",
        f'<rect class="paper" width="{WIDTH}" height="{full}"/>',
        f'<text class="title" x="16" y="28">{html.escape(title)}</text>', *keys, *body, "</svg>", ""])
