// The application as the page's module exports it. A view's scene is named by the handle under
// which the page's session holds it.
#include "app/app.hpp"
#include "bindings/session.hpp"

#include <emscripten/bind.h>

namespace {

using knotwork::bindings::Session;

/// App with scenes named by handle.
class PageApp : public knotwork::app::App {
public:
    explicit PageApp(Session& session) : session_(&session) {}
    void attachHandle(int id, int handle) { attach(id, session_->scene(handle)); }

private:
    Session* session_;
};

}  // namespace

EMSCRIPTEN_BINDINGS(knotwork_app) {
    using emscripten::base;
    using emscripten::class_;
    using knotwork::app::App;
    class_<App>("AppBase")
        .function("start", &App::start)
        .function("contextLost", &App::contextLost)
        .function("contextRestored", &App::contextRestored)
        .function("addView", &App::addView)
        .function("removeView", &App::removeView)
        .function("resize", &App::resize)
        .function("setTheme", &App::setTheme)
        .function("setPanel", &App::setPanel)
        .function("setWords", &App::setWords)
        .function("setReadOnly", &App::setReadOnly)
        .function("setReducedMotion", &App::setReducedMotion)
        .function("focus", &App::focus)
        .function("fit", &App::fit)
        .function("pointer", &App::pointer)
        .function("pinch", &App::pinch)
        .function("wheel", &App::wheel)
        .function("key", &App::key)
        .function("text", &App::text)
        .function("hits", &App::hits)
        .function("cursor", &App::cursor)
        .function("spatial", &App::spatial)
        .function("setPlaying", &App::setPlaying)
        .function("playing", &App::playing)
        .function("setPhase", &App::setPhase)
        .function("phase", &App::phase)
        .function("period", &App::period)
        .function("tick", &App::tick)
        .function("needsFrame", &App::needsFrame)
        .function("render", &App::render)
        .function("labels", &App::labels)
        .function("takeEvents", &App::takeEvents)
        .function("selection", &App::selection)
        .function("select", &App::select)
        .function("selectAll", &App::selectAll)
        .function("setGathering", &App::setGathering)
        .function("held", &App::held)
        .function("setStep", &App::setStep)
        .function("shift", &App::shift)
        .function("place", &App::place)
        .function("panes", &App::panes)
        .function("moveSeam", &App::moveSeam)
        .function("stats", &App::stats);
    class_<PageApp, base<App>>("App")
        .constructor<Session&>()
        .function("attach", &PageApp::attachHandle);
}
