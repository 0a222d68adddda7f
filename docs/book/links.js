// Links that leave the book lead to files of the repository, but mdBook calls `.md` there `.html`.
for (const link of document.querySelectorAll('main a[href^="../"]')) {
    link.setAttribute('href', link.getAttribute('href').replace(/\.html(?=#|$)/, '.md'));
}
