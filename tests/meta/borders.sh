#!/usr/bin/env bash
# Which part may use which library, and that core/ uses nothing above it (layers.sh holds the order within). The headers
# of libraries all lie in /usr/include, so not linking one is not enough.
set -euo pipefail
shopt -s globstar nullglob
export LC_ALL=C
status=0

sources=$(printf '%s\n' {core,chapters,app,tests}/**/*.{h,cpp,inc})

# forbid WHAT PATTERN WHERE [EXCEPT]: no line of a source file whose path matches WHERE and not EXCEPT may match PATTERN
# (Perl syntax).
forbid() {
  local what=$1 pattern=$2 where=$3 except=${4:-^$} found
  found=$(grep -E "$where" <<<"$sources" | grep -Ev "$except" | xargs -r -d '\n' grep -nHP "$pattern" || true)
  if [[ -n $found ]]; then
    printf '%s:\n%s\n' "$what" "$found"
    status=1
  fi
}

includes() { printf '^\\s*#\\s*include\\s*[<"](%s)' "$1"; }
all=.
library='^(core|chapters)/'

forbid 'Dear ImGui outside app/gui' "$(includes '(.*/)?(imgui|imconfig|imstb)')" "$all" '^(app|tests)/gui/'
forbid 'SDL outside app/gui/platform' "$(includes '(.*/)?SDL')|\\b(?!SDL_VIDEODRIVER)(SDL|SDLK?_\\w+|KMOD_\\w+)\\b" "$all" '^app/gui/platform/'
# One test takes the context away from the renderer.
forbid 'OpenGL outside core/hardware, app/gui/platform and its yardstick' \
  "$(includes '(GL|GLES[0-9]?|EGL|KHR|epoxy|glad)/|(.*/)?(gl|glew|glcorearb|SDL_opengl[a-z0-9_]*)\.h[>"]')" \
  "$all" '^(core/hardware|app/gui/platform|tests/bench/llvmpipe)/|^tests/agreement/hardware/lost_context_test'
forbid 'OpenGL by name outside app/gui/platform' '\b(gl[A-Z]\w*\(|GL_[A-Z]|GL(u?int|enum|float|sizei)\b|epoxy_)' '^app/gui/' \
  '^app/gui/platform/'
forbid 'X11 or Wayland' "$(includes '(X11|xcb|wayland)[/-]')" "$all"
forbid 'stb outside core/image' "$(includes '(.*/)?stb_')" "$all" '^core/image/'
thread='std::(jthread|async|thread(?!::))\b|pthread_create'
forbid 'A thread started outside core/base' "$thread" "$library" '^core/base/'
forbid 'A thread of the window started outside app/gui/work and the wait for signals' "$thread" '^app/' \
  '^app/gui/(work/|platform/end_signals\.cpp$)'
forbid 'A tree for the space view built on the thread of the window' '\badd_tree\(' '^app/' '^app/gui/work/'
# The C library's results depend on the processor and on its version; math/portable.h and math/power.h replace them.
forbid 'Functions of the C library whose last bits differ, in what makes pictures' \
  'std::(a?(sin|cos|tan)h?|atan2|exp2?|expm1|pow|log(2|10|1p)?|cbrt|hypot|fma)f?\(' \
  '^core/(accel|frame|raster|raytrace|record|render|scene|shade|textbook)/|^chapters/' '^core/record/value_text'
# The renderers of core are named by the enum and its default, by their rows in the option table, and by the table that
# asks each folder for its row; whatever else must know how a picture is made asks options/renderer_kind.h.
namers='^core/(options/settings\.h|options/renderer\.cpp|render/renderer_table\.cpp)$'
forbid 'One renderer by name: ask for its way of making pictures (options/renderer_kind.h) or its row' \
  '^((?!//).)*(Renderer::(ray_tracer|rasterizer|textbook)\b|\b(ray_tracer|rasterizer|textbook)_row\(|"(ray-tracer|rasterizer|textbook|hardware)"|\brenderer=(ray-tracer|rasterizer|textbook|hardware))' \
  '^(core|chapters|app)/' "^core/(raytrace|raster|textbook|hardware)/|$namers"
forbid 'What libc++ 14 lacks, in core/ or chapters/' \
  "$(includes '(format|source_location|stop_token|syncstream|stacktrace|expected|generator)>')|std::(jthread|stop_token|source_location|format|views|ranges::views)\\b" \
  "$library"

forbid 'A path of shipped files outside core/base/resources' '\b(asset|chapter|font)_dir\(|PIXELSCOPE_(ASSET|CHAPTER|FONT)_DIR' \
  '^(core|chapters|app)/' '^core/base/resources\.'

forbid 'app/ or tests/ in core/ or chapters/' "$(includes '(app|gui|cli|tests|support)/')" "$library"
forbid 'chapters/ in core/' "$(includes 'chapters/')" '^core/'

# A suppression of the thread sanitizer hides every report with its name in a function, a file or a library of the
# stacks: it names a library, and nothing of this project.
while IFS= read -r line; do
  if [[ ! $line =~ ^(race|called_from_lib):(lib[A-Za-z0-9_]{4,}|[a-z]+_dri)(\.so)?$ || $line == *pixelscope* ]] ||
    grep -qF -- "${line#*:}" <<<"$sources $(cat {core,chapters,app}/**/*.{h,cpp,inc})"; then
    printf 'No library of others, in tests/thread_sanitizer.supp: %s\n' "$line"
    status=1
  fi
done < <(grep -vE '^(#|$)' tests/thread_sanitizer.supp)

exit "$status"
