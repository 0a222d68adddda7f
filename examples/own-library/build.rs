fn main() -> Result<(), eliminant_capi_generator::LibraryError> {
    eliminant_capi_generator::Library::new("own").problems("problems").run()
}
