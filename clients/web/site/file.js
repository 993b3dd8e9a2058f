// A page that was opened by a double click cannot load its modules: it says so instead of staying dead.
addEventListener("DOMContentLoaded", () => {
  if (location.protocol !== "file:") return;
  document.getElementById("start").textContent = "This page was opened as a file, and a browser does not let a file load "
    + "the page's program. Serve its folder, for example with “python3 -m http.server”, and open the address that it prints.";
});
