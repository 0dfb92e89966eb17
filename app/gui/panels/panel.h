#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "gui/base/file_question.h"
#include "gui/base/values.h"
#include "gui/input/actions.h"
#include "gui/panels/messages.h"
#include "gui/session/session.h"

namespace ps::gui {

/// Services of the window for its panels.
struct PanelHost {
  Session& session;
  std::function<void()> wake;  ///< from any thread: there is something new
  bool remember = false;       ///< results and answers, from one start to the next
  std::function<std::string(const std::string& key)> remembered;
  std::function<void(const std::string& key, std::string lines)> remember_lines;  ///< a list, one entry a line
  /// Puts text on the clipboard and shows `said`.
  std::function<void(const std::string& text, const std::string& said)> copy;
  std::function<void(FileQuestion question)> ask_file;
  /// To all panels and the window, at once.
  std::function<void(const PanelMessage& message)> send;
  /// Whether the pictures render, or times are measured: what would take processors from these waits.
  std::function<bool()> needs_processors;
};

/// With what a panel is drawn.
struct Context {
  bool filled = false;   ///< the panel has the window for itself
  bool headed = false;   ///< what its head() draws is in the line above it
  bool in_line = false;  ///< its first control follows another one, in the same line
};

/// The height that a tool needs: a strip below the pictures, or the height of one of them.
enum class PanelHeight { strip, tall };

/// The subject of a tool: the picked pixel, or all of the pictures, for which it may work long.
enum class PanelUse { pixel, study };

/// The tab below the pictures under which a tool is shown.
enum class ToolGroup { pixel, pixels, measure, stability };

/// Where a panel has its place; a sheet is over the whole window.
enum class PanelPlace { left, right, below, over };

/// Whether a panel would answer an open question about the picked pixel, and is covered until the answer.
enum class Answers { no, yes };

/// How a panel is called, and where it belongs.
struct PanelFacts {
  std::string_view name;  ///< stable: of the document's layout, of scripts
  PanelPlace place = PanelPlace::below;
  PanelUse use = PanelUse::pixel;
  ToolGroup group = ToolGroup::pixel;
  PanelHeight height = PanelHeight::strip;
  Answers answers = Answers::no;
  std::string_view heading{}, brief{};  ///< brief where there is little room
  std::string_view command{};           ///< in menus and the palette
  std::string_view help{};              ///< one sentence
};

/// A part of the window. A panel below the pictures is a tool. It owns its state, edits the document by its session,
/// and asks the others by messages.
class Panel {
 public:
  virtual ~Panel() = default;
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;
  const PanelFacts facts;

  /// Answers whether the panel shall fill the window, or no longer.
  virtual bool draw(const Context& context) = 0;
  /// Draws the controls that have room in the panel's title bar, where it needs all of the height below; answers like
  /// draw().
  virtual bool head() { return false; }
  virtual void add_actions(Actions&) {}
  /// Entries of the palette besides actions, each time that it opens.
  virtual void add_entries(std::vector<PaletteEntry>&) {}
  /// Its values for scripts; it outlives them.
  virtual void offer(Values&) {}
  /// Once a frame, shown or not, in any order.
  virtual void update() {}
  /// Work is going on, or has come and was not taken up.
  virtual bool busy() const { return false; }
  /// It measures times now.
  virtual bool measures_times() const { return false; }
  /// Long work, for the line at the lower edge; empty if there is none.
  virtual std::string status() const { return {}; }
  virtual void take(const PanelMessage&) {}
  /// Esc: takes back what a drag that goes on has changed, and ends it. Answers whether one went on.
  virtual bool cancel_drag() { return false; }
  /// Esc: closes what is open over the window. Answers whether something was.
  virtual bool close() { return false; }

 protected:
  /// `host` must outlive it.
  Panel(const PanelHost& host, const PanelFacts& of) : facts(of), host_(host), session_(host.session) {}

  const PanelHost& host_;
  Session& session_;
};

/// Panels in the order of their tabs.
using PanelList = std::vector<std::reference_wrapper<Panel>>;

/// The panel of that name; the first tool where there is none.
Panel& find_panel(const PanelList& panels, std::string_view name);

/// The toolbar ends here. Scripts know the room that is left as "tool/room": width and height at scale 1.
void begin_tool_content();

/// Whether a worker is at work, or has news that were not taken up.
template <class Worker>
bool works(const Worker& worker) {
  return worker.busy() || worker.has_news();
}

/// A view that is not drawn, or has no room, asks for no work in this frame and keeps no worker busy.
template <class Worker>
void wait_unless_drawn(Worker& worker) {
  worker.rest();
  worker.take_news();
}

}  // namespace ps::gui
