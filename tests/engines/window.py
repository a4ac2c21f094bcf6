#!/usr/bin/python3
"""A window of WebKit that WebKitWebDriver drives: `window.py [--unaccelerated] DOWNLOADS [DATA]`.

With a data folder, it stores data of pages, like a browser. Without one, it is a private window, which stores
nothing. `--unaccelerated` turns off the emulation of a graphics card, which takes a third of the time. Then
there are no events for shown video frames (`requestVideoFrameCallback`). Downloads go to DOWNLOADS.
`MiniBrowser --automation`, a part of WebKit, is always private.
"""

import sys
from pathlib import Path

import gi

gi.require_version("Gtk", "3.0")
gi.require_version("WebKit2", "4.1")
from gi.repository import Gtk, WebKit2  # noqa: E402  (versions come first)


def store(data):
    if data is None:
        return WebKit2.WebContext.new_ephemeral()
    manager = WebKit2.WebsiteDataManager(
        base_data_directory=str(data / "data"), base_cache_directory=str(data / "cache")
    )
    return WebKit2.WebContext(website_data_manager=manager)


def main(downloads, data, accelerated):
    context = store(data)
    context.set_automation_allowed(True)

    policy = WebKit2.HardwareAccelerationPolicy
    settings = WebKit2.Settings(hardware_acceleration_policy=policy.ALWAYS if accelerated else policy.NEVER)

    def window(_session):
        view = WebKit2.WebView(is_controlled_by_automation=True, web_context=context, settings=settings)
        shell = Gtk.Window()
        shell.set_default_size(1280, 800)
        shell.add(view)
        shell.show_all()
        view.connect("close", lambda _view: shell.destroy())
        return view

    def started(_context, session):
        about = WebKit2.ApplicationInfo()
        about.set_name("window.py")
        about.set_version(WebKit2.get_major_version(), WebKit2.get_minor_version(), 0)
        session.set_application_info(about)
        session.connect("create-web-view", window)

    def destined(download, name):
        download.set_destination((downloads / Path(name).name).as_uri())
        return True

    context.connect("automation-started", started)
    context.connect("download-started", lambda _context, download: download.connect("decide-destination", destined))
    Gtk.main()


folders = [Path(argument).absolute() for argument in sys.argv[1:] if not argument.startswith("-")]
main(folders[0], folders[1] if len(folders) > 1 else None, "--unaccelerated" not in sys.argv)
