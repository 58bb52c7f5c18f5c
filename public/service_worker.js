// Keeps the page usable without a network after the first visit. site_files.js is written by the build: a
// version, and every file of the page. Each version has a cache of its own, and an older one goes when a newer
// one takes over.
importScripts('site_files.js')
const { version, files } = self.stridegraphSite
const CACHE = `stridegraph-${version}`

self.addEventListener('install', (event) => {
  const requests = files.map((file) => new Request(file, { cache: 'no-cache' }))
  event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(requests)))
})

self.addEventListener('activate', (event) => {
  const isOld = (name) => name.startsWith('stridegraph-') && name !== CACHE
  event.waitUntil(
    caches.keys().then((names) => Promise.all(names.filter(isOld).map((name) => caches.delete(name)))),
  )
})

// The network first, so that nobody sees a stale page; the cache when there is none.
self.addEventListener('fetch', (event) => {
  const { request } = event
  if (request.method !== 'GET' || new URL(request.url).origin !== self.location.origin) return
  const fromCache = async (problem) => {
    const cache = await caches.open(CACHE)
    const found = await cache.match(request.mode === 'navigate' ? './' : request, { ignoreSearch: true })
    if (found) return found
    throw problem
  }
  event.respondWith(fetch(request).catch(fromCache))
})
